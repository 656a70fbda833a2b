// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "estimation/association/box_reading.hpp"
#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// Joint uncertainty of a pose and an object: first six of the pose, last three of the object.
using PoseObjectCovariance = Eigen::Matrix<double, 9, 9>;

struct BoxGateParams {
  double model_error_px = 4.0;         ///< that no covariance knows of
  double model_error_share = 0.08;     ///< further share of the box's size
  double range_sigma = 0.2;            ///< relative, of the distance from size
  double new_object_share = 0.1;       ///< of boxes that show what no object explains
  double confused_class_share = 0.03;  ///< of boxes with the wrong class
  double chi2_per_gate = 16.3;         ///< no match beyond: Mahalanobis, [Bar-Shalom 2001]
  double overlap_share = 0.4;          ///< of the box: centres nearer than this always may match
};

/// How well a box fits an object: -2 ln of its likelihood, and of being something new.
struct BoxMatch {
  double cost = 0.0;
  double new_cost = 0.0;
  double distance2 = 0.0;  ///< squared Mahalanobis distance
  double spread_px = 0.0;  ///< 1-sigma of where the box was expected, in the worst direction
};

/// What a box may show, as seen from a pose of which it is jointly uncertain.
struct ExpectedObject {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< [m]
  std::string color;
  PoseObjectCovariance covariance = PoseObjectCovariance::Zero();
  /// What doubt about the camera itself adds, in its frame [m^2].
  Eigen::Matrix3d mount_C = Eigen::Matrix3d::Zero();
};

/// A box and what it says.
struct ReadDetection {
  Box box;
  BoxReading reading;
};

/// Compares boxes with where objects should appear.
class BoxGate {
 public:
  /// `camera` must outlive it.
  BoxGate(const CameraModel& camera, const BoxGateParams& params)
      : camera_(camera), params_(params) {}

  /// Axes that a border cuts are compared by the one edge that shows; boxes that tell it also by
  /// their size. Nothing when the box, seen from the pose `x`, cannot be the object.
  [[nodiscard]] std::optional<BoxMatch> Match(const ReadDetection& seen, const NavVector& x,
                                              const ExpectedObject& object) const;

 private:
  const CameraModel& camera_;
  BoxGateParams params_;
};

}  // namespace limpet
