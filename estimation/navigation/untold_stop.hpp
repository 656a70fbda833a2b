// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// What nobody would notice while no velocity is measured: that the vehicle stopped. It may have at
/// any time since, each as likely; then it has not gone what it is believed to have gone through
/// the water from there on. Seldom, but far: a covariance of both cases together.
class UntoldStop {
 public:
  /// It goes on as believed: `way_D` through the water [m] in `seconds`.
  void GoOn(const Eigen::Vector2d& way_D, double seconds) {
    const Eigen::Vector2d before = way_;
    way_ += way_D;
    seconds_ += seconds;
    const Eigen::Vector2d middle = 0.5 * (before + way_);
    sum_ += seconds * middle;
    squares_ += seconds * middle * middle.transpose();
  }
  /// Covariance of the place by now, in the axes of `way` [m^2], of a vehicle that stops so often
  /// [1/s].
  [[nodiscard]] Eigen::Matrix2d Covariance(double stop_rate) const {
    const Eigen::Matrix2d crossed = sum_ * way_.transpose();
    return stop_rate *
           (seconds_ * way_ * way_.transpose() - crossed - crossed.transpose() + squares_);
  }

 private:
  Eigen::Vector2d way_ = Eigen::Vector2d::Zero();  ///< gone so far [m]
  double seconds_ = 0.0;
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();      ///< of the way, over time [m s]
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();  ///< of its squares [m^2 s]
};

}  // namespace limpet
