// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

struct VelocityGateParams {
  MetersPerSecond jump{0.15};  ///< change against the last accepted velocity that always passes
  double growth_mps2 = 0.15;   ///< further allowance per second since then [m/s^2]
};

/// Sorts out gross outliers of bottom-track velocity: a sample passes when it differs from the last
/// accepted one by no more than an allowance that grows with its age, so that a long dropout, or a
/// wrong first sample, cannot lock the gate.
class VelocityGate {
 public:
  explicit VelocityGate(const VelocityGateParams& params) : params_(params) {}

  /// True if `v_B` [m/s], measured at `t` [s], is to be used.
  [[nodiscard]] bool Accepts(double t, const Eigen::Vector3d& v_B) {
    if (!v_B.allFinite()) {
      return false;
    }
    if (last_) {
      const double allowance = params_.jump.value() + params_.growth_mps2 * (t - last_->t);
      if ((v_B - last_->v_B).norm() > allowance) {
        return false;
      }
    }
    last_ = Sample{t, v_B};
    return true;
  }

 private:
  struct Sample {
    double t;
    Eigen::Vector3d v_B;
  };
  VelocityGateParams params_;
  std::optional<Sample> last_;
};

}  // namespace limpet
