// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/topics/navigation.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const limpet::Value text = std::string(reinterpret_cast<const char*>(data), size);
  static_cast<void>(limpet::TopicCodec<limpet::NavState>::Decode(text));
  // What decodes must come back the same when it is sent on.
  if (const auto ping = limpet::TopicCodec<limpet::DvlSample>::Decode(text)) {
    const limpet::Value once = limpet::TopicCodec<limpet::DvlSample>::Encode(*ping);
    const auto again = limpet::TopicCodec<limpet::DvlSample>::Decode(once);
    if (!again || limpet::TopicCodec<limpet::DvlSample>::Encode(*again) != once) {
      std::abort();
    }
  }
  return 0;
}
