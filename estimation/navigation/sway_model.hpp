// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// How much sideways velocity turning brings, at the DVL: its lever arm times the yaw rate, and
/// what the hull slips in a turn, which is nearly in proportion. Learned while there is velocity,
/// for when there is none.
class SwayModel {
 public:
  /// `arm`: how far ahead of the body's origin the DVL is [m]; taken until something is learned.
  explicit SwayModel(double arm) : arm_(arm) {}

  /// A velocity sideways, off the usual one [m/s], at a yaw rate [rad/s], that holds for `dt` [s].
  void Add(double sideways, double yaw_rate, double dt) {
    const double keep = std::exp(-dt / kMemory);
    turning_ = keep * turning_ + yaw_rate * yaw_rate * dt;
    swaying_ = keep * swaying_ + yaw_rate * sideways * dt;
  }
  /// Sideways velocity per yaw rate [m/s per rad/s].
  [[nodiscard]] double per_rate() const {
    return (kArmWeight * arm_ + swaying_) / (kArmWeight + turning_);
  }

 private:
  static constexpr double kMemory = 600.0;    // [s]
  static constexpr double kArmWeight = 0.05;  // [rad^2/s]: a few seconds of turning
  double arm_;
  double turning_ = 0.0, swaying_ = 0.0;
};

}  // namespace limpet
