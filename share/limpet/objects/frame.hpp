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

/// How sure the vehicle is of where it was, horizontally: 1-sigma, mean of the two axes [m].
struct PlaceSigma {
  double absolute = 0.0;  ///< in W: how far the whole map may be off there
  /// Against where it was when it passed nearest by before: how far two passes may have come
  /// closer together, or apart. 0 where it never was near.
  double beside = 0.0;
};

/// One image as the vehicle understands it: where it was taken from, and which landmark each box
/// shows. All that the map needs of it.
struct ObservedFrame {
  int frame = 0;
  Seconds exposure;  ///< MOOS time; of a former session's frames, since its first one
  Pose X_WB;         ///< at the exposure
  std::optional<double> altitude = std::nullopt;  ///< of the body origin above the seabed [m]
  std::vector<Box> boxes = {};
  std::optional<PlaceSigma> sigma = std::nullopt;  ///< absent: taken for exact
};

/// A frame that a former session mapped by.
struct FormerView {
  ObservedFrame frame;  ///< its altitude is the last one heard until then
  Seconds altitude_age;
};

}  // namespace limpet
