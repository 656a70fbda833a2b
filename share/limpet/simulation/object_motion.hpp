// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How an object moves within a session: on its line, or for good.
struct ObjectMotionParams {
  Eigen::Vector3d sway_W = Eigen::Vector3d::Zero();
  Seconds sway_period{8.0};
  Eigen::Vector3d drift_W = Eigen::Vector3d::Zero();

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("sway_m", sway_W, "m", "Swings by so much north, east and down to either side",
          InRange(-10.0, 10.0));
    visit("sway_period_s", sway_period, "Period of the sway", InRange(0.5_s, 3600.0_s));
    visit("drift_mps", drift_W, "mps", "Goes so fast north, east and down, from its place on",
          InRange(-2.0, 2.0));
  }
  /// How far the object is from its place [m], `since` the session began.
  [[nodiscard]] Eigen::Vector3d At(Seconds since) const {
    const double phase = 2.0 * std::numbers::pi * (since / sway_period);
    return std::sin(phase) * sway_W + since.value() * drift_W;
  }
};

}  // namespace limpet
