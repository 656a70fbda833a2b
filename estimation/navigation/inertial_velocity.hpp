// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include <Eigen/Core>

namespace limpet {

/// What the accelerometer makes of the last velocity that was believed: a second opinion, good for
/// as long as its bias and the tilt's error do not count. Times in seconds; R_DB turns from the
/// body into axes that are level and do not turn with it.
class InertialVelocity {
 public:
  /// Specific force in body axes [m/s^2]. Out of order it is ignored.
  void AddForce(double t, const Eigen::Vector3d& force_B, const Eigen::Matrix3d& R_DB);
  /// This was the velocity over ground [m/s].
  void Believe(double t, const Eigen::Vector3d& v_B, const Eigen::Matrix3d& R_DB);
  /// Velocity in body axes [m/s]; nothing if it was believed too long ago, or forces are missing
  /// since.
  [[nodiscard]] std::optional<Eigen::Vector3d> At(double t, const Eigen::Matrix3d& R_DB) const;

 private:
  struct Sample {
    double t = 0.0;
    Eigen::Vector3d gained_D = Eigen::Vector3d::Zero();  ///< since the first sample
    Eigen::Vector3d acceleration_D = Eigen::Vector3d::Zero();
  };
  struct Believed {
    double t = 0.0;
    Eigen::Vector3d v_D = Eigen::Vector3d::Zero();
  };
  /// Velocity gained up to `t`; nothing outside the samples.
  [[nodiscard]] std::optional<Eigen::Vector3d> GainedAt(double t) const;

  std::deque<Sample> samples_;
  std::optional<Believed> believed_;
};

}  // namespace limpet
