// SPDX-License-Identifier: MIT
// World W: local north-east-down at the mission's datum. Body B: forward-right-down. Only this file
// converts to MOOS.
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Wraps an angle [rad] to (-pi, pi].
[[nodiscard]] double WrapAngle(double radians);

/// Pose of the body in W: position [m] and roll, pitch, yaw [rad]; R_WB = Rz(yaw) Ry(pitch)
/// Rx(roll).
struct Pose {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  double roll = 0.0;
  double pitch = 0.0;
  double yaw = 0.0;
};

/// Rotation that takes body vectors to NED: Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] Eigen::Matrix3d RotationFromRollPitchYaw(double roll, double pitch, double yaw);
[[nodiscard]] Eigen::Matrix3d RotationOf(const Pose& X_WB);

/// Roll, pitch, yaw [rad] of a body-to-NED rotation; pitch in [-pi/2, pi/2].
[[nodiscard]] Eigen::Vector3d RollPitchYawFromRotation(const Eigen::Matrix3d& R_WB);

/// MOOS's local grid: x east [m], y north [m], heading degrees clockwise from north in [0, 360),
/// yaw radians counter-clockwise from east in (-pi, pi], depth positive down [m].
struct MoosPose {
  double x = 0.0;
  double y = 0.0;
  double depth = 0.0;
  double heading_deg = 0.0;
  double yaw = 0.0;
};

[[nodiscard]] double MoosHeadingFromYaw(double yaw_ned);
[[nodiscard]] double YawFromMoosHeading(double heading_deg);
[[nodiscard]] MoosPose MoosFromNed(const Eigen::Vector3d& p_WB, double yaw_ned);

}  // namespace limpet
