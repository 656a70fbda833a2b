// SPDX-License-Identifier: MIT
// What a look at a place is. The map counts looks by this and the helm plans them by it, so that
// what one plans the other counts.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/survey/detection_chance.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// What judges a look: the camera with its mount, how well the detector sees, and how large the
/// objects are.
struct LookModel {
  CameraModel camera;
  DetectionModel detection;
  double object_radius = 0.5;  ///< [m]
};

/// Chance that the frame taken at `X_WB` shows a box for an object at `p_W` (centre, NED), if one
/// is there: its disc must be inside the image and within range.
[[nodiscard]] double ChanceToDetect(const LookModel& model, const Pose& X_WB,
                                    const Eigen::Vector3d& p_W);
/// That chance in water of each of several visibilities [m].
[[nodiscard]] PerVisibility ChancesToDetect(const LookModel& model, const Pose& X_WB,
                                            const Eigen::Vector3d& p_W,
                                            const PerVisibility& visibilities);
/// A frame with at least this chance is a look: it would more likely than not show an object.
inline constexpr double kLookChance = 0.5;

/// Where a place must lie, seen from a level camera above it, to be looked at: a rectangle around
/// the point below the camera, half extents in metres.
struct LookWindow {
  double half_along = 0.0;
  double half_across = 0.0;
  [[nodiscard]] bool Contains(const Eigen::Vector2d& offset_H) const {
    return std::abs(offset_H.x()) <= half_along && std::abs(offset_H.y()) <= half_across;
  }
};
/// A place as a look at it is planned.
struct PlaceBelow {
  double drop = 0.0;   ///< below the camera [m]
  double slack = 0.0;  ///< how far elsewhere it may lie, level [m]
};
/// The window of a camera above a place. If that lies elsewhere by its slack, a place in the window
/// is still looked at, as far as that leaves a window of some size. Nothing if even right below the
/// camera the place would not be seen.
[[nodiscard]] std::optional<LookWindow> LookWindowAbove(const LookModel& model,
                                                        const PlaceBelow& place);

/// The model as MAP_LOOK carries it, and back: of a camera that looks straight down from the body's
/// origin, for where it is mounted MAP_LOOK does not say.
[[nodiscard]] MapLook ToMapLook(const LookModel& model);
[[nodiscard]] LookModel ToLookModel(const MapLook& look);

}  // namespace limpet
