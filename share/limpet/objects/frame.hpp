// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/box.hpp"

namespace limpet {

/// All boxes of one image, as the detector has them; also of one that shows nothing.
struct Detections {
  int frame = 0;
  Seconds exposure;  ///< MOOS time
  std::vector<Box> boxes;
};

/// One image as the vehicle understands it: where it was taken from, and which landmark each box
/// shows. All that the map needs of it.
struct ObservedFrame {
  int frame = 0;
  Seconds exposure;  ///< MOOS time; of a former session's frames, since its first one
  Pose X_WB;         ///< at the exposure
  std::optional<double> altitude = std::nullopt;  ///< of the body origin above the seabed [m]
  std::vector<Box> boxes = {};
};

/// A frame that a former session mapped by.
struct FormerView {
  ObservedFrame frame;  ///< its altitude is the last one heard until then
  Seconds altitude_age;
};

}  // namespace limpet
