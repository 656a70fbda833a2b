// SPDX-License-Identifier: MIT
// A log of MOOS; what of it is navigation is checked, said, and made a stream.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/recordings/check_text.hpp"
#include "limpet/recordings/moos_log.hpp"
#include "limpet/recordings/own_track.hpp"
#include "limpet/recordings/recording_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limpet::AlogReader reader =
      limpet::AlogReader::OfText({reinterpret_cast<const char*>(data), size});
  const auto recording = limpet::ReadMoosLog(reader, "some.alog");
  if (!recording) return 0;
  const limpet::RecordingCheck check = limpet::Check(*recording);
  if (limpet::CheckText(*recording, check).empty()) std::abort();
  if (limpet::CheckJson(*recording, check).empty()) std::abort();
  const auto stream = limpet::StreamOf(*recording, limpet::Radians(0.01));
  if (stream && stream->rows.empty()) std::abort();
  return 0;
}
