// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace {
template <class T>
void RoundTrip(const limpet::Value& text) {
  if (const auto value = limpet::TopicCodec<T>::Decode(text)) {
    const limpet::Value once = limpet::TopicCodec<T>::Encode(*value);
    const auto again = limpet::TopicCodec<T>::Decode(once);
    if (!again || limpet::TopicCodec<T>::Encode(*again) != once) {
      std::abort();  // what decodes must come back the same when it is sent on
    }
  }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const limpet::Value text = std::string(reinterpret_cast<const char*>(data), size);
  RoundTrip<limpet::Detections>(text), RoundTrip<limpet::HelmBids>(text);
  RoundTrip<limpet::OpiBeliefs>(text), RoundTrip<limpet::ObservedFrame>(text);
  RoundTrip<limpet::WaterRecord>(text), RoundTrip<limpet::SessionPrior>(text);
  return 0;
}
