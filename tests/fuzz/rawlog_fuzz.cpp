// SPDX-License-Identifier: MIT
// A rawlog, unpacked; what is understood goes through a rawlog again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "estimation/replay/rawlog.hpp"

/// MRPT 2.5.8 loses the message of a CObservationGPS, 80 bytes, where the file ends inside it.
extern "C" const char* __lsan_default_suppressions() { return "leak:gnss_message::Factory"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream =
      limpet::ParseRawlog({reinterpret_cast<const char*>(data), size}, "some.rawlog");
  if (!stream) return 0;
  if (stream->rows.empty()) std::abort();
  const limpet::PackedRawlog packed = limpet::ToRawlog(*stream);
  if (packed.untimely_rows > static_cast<int>(stream->rows.size()) * 2) std::abort();
  return 0;
}
