// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "estimation/navigation/pose_chain.hpp"

namespace limpet {

/// Pose and velocity at `t` [s], as known now; 1-sigma of the pose.
struct NavigatorEstimate {
  double t = 0.0;
  Pose X_WB;
  Eigen::Vector3d v_B = Eigen::Vector3d::Zero();  ///< of the body origin [m/s]
  double yaw_rate = 0.0;                          ///< [rad/s]
  std::optional<double> altitude;  ///< of the body origin above the seabed [m], if measured lately
  std::optional<double> velocity_age;                ///< of `v_B` [s], in a dropout of the DVL
  Eigen::Vector3d sd_p_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d covariance_p_W = Eigen::Matrix3d::Zero();  ///< of the position [m^2]
  double sd_yaw = 0.0;                                       ///< [rad]
};

/// Estimate from the chain's head, by dead reckoning, with what silence of the sensors adds.
/// REQUIRES: chain.has_begun().
[[nodiscard]] NavigatorEstimate EstimateAt(double t, const PoseChain& chain,
                                           const Smoother& smoother,
                                           const MeasurementBuffer& measurements);

}  // namespace limpet
