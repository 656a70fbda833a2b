// SPDX-License-Identifier: MIT
// Boxes through a lens that distorts: the one way there, for who makes boxes, and the one back, for
// who believes them.
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/lens_model.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// What a detector's box of the distorted image is in the lens' rectified image: round what is
/// round in the box. An edge that the image's border cuts is cut in the rectified one, too; nothing
/// if no pixel of it is there.
[[nodiscard]] std::optional<Box> Rectified(const LensModel& lens, const Box& box);
struct RectifiedFrame {
  Detections frame;          ///< with the boxes that are there
  std::vector<int> numbers;  ///< of each of them among the detector's
};
[[nodiscard]] RectifiedFrame Rectified(const LensModel& lens, const Detections& frame);

/// What a box of the lens' enclosing image is in the distorted one; nothing if it is not there.
[[nodiscard]] std::optional<Box> Distorted(const LensModel& lens, const Box& box);

}  // namespace limpet
