// SPDX-License-Identifier: MIT
#include "limpet/core/frames.hpp"

#include <cmath>
#include <numbers>

#include "limpet/core/units.hpp"

namespace limpet {

double WrapAngle(double radians) {
  const double wrapped = std::remainder(radians, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

Eigen::Matrix3d RotationFromRollPitchYaw(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll);
  const double cp = std::cos(pitch), sp = std::sin(pitch);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  Eigen::Matrix3d R;
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

Eigen::Matrix3d RotationOf(const Pose& X_WB) {
  return RotationFromRollPitchYaw(X_WB.roll, X_WB.pitch, X_WB.yaw);
}

Eigen::Vector3d RollPitchYawFromRotation(const Eigen::Matrix3d& R_WB) {
  const double horizontal = std::hypot(R_WB(2, 1), R_WB(2, 2));
  return {std::atan2(R_WB(2, 1), R_WB(2, 2)), std::atan2(-R_WB(2, 0), horizontal),
          std::atan2(R_WB(1, 0), R_WB(0, 0))};
}

double MoosHeadingFromYaw(double yaw_ned) {
  const double degrees = DegreesFromRadians(WrapAngle(yaw_ned));
  const double heading = degrees < 0.0 ? degrees + 360.0 : degrees;
  return heading >= 360.0 ? 0.0 : heading;  // -1e-17 + 360 rounds to 360
}

double YawFromMoosHeading(double heading_deg) { return WrapAngle(RadiansFromDegrees(heading_deg)); }

MoosPose MoosFromNed(const Eigen::Vector3d& p_WB, double yaw_ned) {
  return {.x = p_WB.y(),
          .y = p_WB.x(),
          .depth = p_WB.z(),
          .heading_deg = MoosHeadingFromYaw(yaw_ned),
          .yaw = WrapAngle(0.5 * std::numbers::pi - yaw_ned)};
}

}  // namespace limpet
