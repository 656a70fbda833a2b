// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

struct VelocityGateParams {
  MetersPerSecond jump{0.15};   ///< change against the last accepted velocity that always passes
  double growth_mps2 = 0.15;    ///< further allowance per second since then [m/s^2]
  Seconds longest_growth{1.0};  ///< no older velocity allows more
};

/// Sorts out gross outliers of bottom-track velocity: a sample passes when it differs from the last
/// accepted one by no more than an allowance that grows with its age, or agrees with the sample
/// before it that was refused. So neither a long dropout nor a wrong first sample can lock the
/// gate, nor can one outlier at a dropout's end become the truth.
class VelocityGate {
 public:
  explicit VelocityGate(const VelocityGateParams& params) : params_(params) {}

  /// True if `v_B` [m/s], measured at `t` [s], is to be used.
  [[nodiscard]] bool Accepts(double t, const Eigen::Vector3d& v_B) {
    if (!v_B.allFinite()) {
      return false;
    }
    const Sample sample{t, v_B};
    if (last_ && !Agrees(sample, *last_) && !(refused_ && Agrees(sample, *refused_))) {
      refused_ = sample;
      return false;
    }
    last_ = sample;
    refused_.reset();
    return true;
  }

 private:
  struct Sample {
    double t;
    Eigen::Vector3d v_B;
  };
  [[nodiscard]] bool Agrees(const Sample& a, const Sample& b) const {
    const double age = std::min(a.t - b.t, params_.longest_growth.value());
    return (a.v_B - b.v_B).norm() <= params_.jump.value() + params_.growth_mps2 * age;
  }
  VelocityGateParams params_;
  std::optional<Sample> last_, refused_;
};

}  // namespace limpet
