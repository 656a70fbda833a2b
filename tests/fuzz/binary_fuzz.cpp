// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/topics/chips.hpp"
#include "limpet/topics/map_tile.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/packed_bytes.hpp"
#include "limpet/topics/sensors.hpp"

namespace {
template <class T>
void RoundTrip(const limpet::Value& bytes) {
  if (const auto value = limpet::TopicCodec<T>::Decode(bytes)) {
    if (!limpet::TopicCodec<T>::Decode(limpet::TopicCodec<T>::Encode(*value))) {
      std::abort();  // what decodes must decode again when it is sent on
    }
  }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const limpet::Value bytes = limpet::Binary(first, first + size);
  RoundTrip<limpet::CameraFrame>(bytes);
  RoundTrip<limpet::GridDelta>(bytes);
  RoundTrip<limpet::ImageChips>(bytes);
  RoundTrip<limpet::MapTile>(bytes);
  RoundTrip<limpet::PackedBytes>(bytes);
  return 0;
}
