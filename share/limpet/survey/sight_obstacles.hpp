// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Where the camera is, NED [m].
[[nodiscard]] inline Eigen::Vector3d EyeOf(const CameraModel& camera, const Pose& X_WB) {
  return X_WB.p_WB + RotationOf(X_WB) * camera.p_BC;
}

/// What obstacles hide from a camera: one shadow behind each. Cheap to ask for every cell of an
/// image, and for nothing where there is none.
class Shadows {
 public:
  [[nodiscard]] bool empty() const { return shadows_.empty(); }
  /// Whether an obstacle stands between the camera and a place (NED). What lies in an obstacle's
  /// outline counts as behind it from the middle on.
  [[nodiscard]] bool Hide(const Eigen::Vector3d& place_W) const;

 private:
  friend class SightObstacles;
  /// Shadow of one obstacle, between the lines of sight past its sides and behind the line from
  /// side to side, as far down as rays that pass over its top come.
  struct Shadow {
    Eigen::Vector2d right, left;  ///< sides as the camera sees them, from the camera
    double top;                   ///< NED depth [m]
  };
  Eigen::Vector3d eye_W_ = Eigen::Vector3d::Zero();
  std::vector<Shadow> shadows_;
};

/// Obstacles as pMap found them, as what a camera does not see through.
class SightObstacles {
 public:
  SightObstacles() = default;
  /// Outlines that are none are left out.
  explicit SightObstacles(const std::vector<Obstacle>& obstacles);

  [[nodiscard]] bool empty() const { return bodies_.empty(); }
  /// What obstacles hide that are within `reach` of the camera [m]; one that holds the camera has
  /// none.
  [[nodiscard]] Shadows From(const Eigen::Vector3d& eye_W, double reach) const;
  /// Whether an obstacle hides this place.
  [[nodiscard]] bool Hide(const Eigen::Vector3d& eye_W, const Eigen::Vector3d& place_W) const;

 private:
  struct Body {
    SimplePolygon outline;
    double top;
  };
  std::vector<Body> bodies_;
};

}  // namespace limpet
