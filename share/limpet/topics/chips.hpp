// SPDX-License-Identifier: MIT
// Pictures of what the detector saw, for people.
#pragma once

#include <optional>

#include "limpet/core/message.hpp"
#include "limpet/objects/image_chips.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// Little-endian: magic "LIC1", count u32, exposure f64; per chip u, v, w, h, confidence f32, then
/// class and JPEG, each as length u32 and bytes.
template <>
struct TopicCodec<ImageChips> {
  [[nodiscard]] static Value Encode(const ImageChips& chips);
  [[nodiscard]] static std::optional<ImageChips> Decode(const Value& value);
};

namespace topics {
inline const auto kDetectionChips = Declare<ImageChips>(
    "DETECTION_CHIPS", "boxes cut out of their image, as JPEG",
    {.unit = "px, s", .frame = "image", .rate = "at most 1 Hz", .writers = {"pDetect"}});
}  // namespace topics

}  // namespace limpet
