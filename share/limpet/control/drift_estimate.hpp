// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// The integral part of surge and sway, held as a current in the world frame: what drives the
/// vehicle off its wanted velocity is mostly water that moves, and that keeps its direction while
/// the vehicle turns. A body-fixed integral would have to learn it again on every arc.
class DriftEstimate {
 public:
  struct Gains {
    double along = 0.4;   ///< current per error of surge and second [1/s]
    double across = 0.5;  ///< same of sway; sway drag is small, so it has to learn faster
    double limit = 0.6;   ///< [m/s]
  };
  explicit DriftEstimate(const Gains& gains) : gains_(gains) {}

  /// Takes what surge and sway over ground lack [m/s] and gives the current in body axes [m/s].
  /// Stands still while thrusters saturate.
  Eigen::Vector2d Update(double yaw, const Eigen::Vector2d& lack_B, double dt, bool is_saturated);
  void Reset() { current_W_.setZero(); }

 private:
  Gains gains_;
  Eigen::Vector2d current_W_ = Eigen::Vector2d::Zero();
};

}  // namespace limpet
