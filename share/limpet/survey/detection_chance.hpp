// SPDX-License-Identifier: MIT
// The chance that one frame shows a box for an object that is there. docs/references.md, "Change
// posterior".
#pragma once

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/detection_model.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// How one frame shows an object.
struct Showing {
  double range = 0.0;  ///< from the camera [m]
  double share = 1.0;  ///< of it inside the image
};
/// Chance of a box.
[[nodiscard]] double DetectionChance(const DetectionModel& detector, const Showing& object);
/// The chance in water of each of several visibilities [m], instead of the detector's.
[[nodiscard]] PerVisibility DetectionChances(const DetectionModel& detector, const Showing& object,
                                             const PerVisibility& visibilities);
/// Factor on that for an object whose image has this diameter.
[[nodiscard]] double SizeFactor(const DetectionModel& detector, double size_px);
/// The range at which half the chance that there is close by is left [m].
[[nodiscard]] double HalfRange(const DetectionModel& detector);
/// The visibility at which this range is what it is on average over `water`.
[[nodiscard]] Meters MeanVisibility(const DetectionModel& detector, const VisibilityBelief& water);

/// Share of a sphere's disc (centre p_W, NED, radius [m]) that lies inside the image; 0 behind the
/// camera.
[[nodiscard]] double VisibleShare(const CameraModel& camera, const Pose& X_WB,
                                  const Eigen::Vector3d& p_W, double radius);

}  // namespace limpet
