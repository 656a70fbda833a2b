// SPDX-License-Identifier: MIT
#include "behaviors/BHV_HoldStation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/frames.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

constexpr double kBack = 0.25;        // of the radius: the station is reached
constexpr double kApproach = 0.3;     // speed per distance left [1/s]
constexpr double kLongestStep = 1.0;  // [s] over which one velocity is believed
constexpr double kSkirt = 0.5;        // [m/s]

}  // namespace

void BHV_HoldStation::Start(const VehicleState& state) {
  heading_ = state.nav.yaw;
  offset_W_.setZero();
  is_returning_ = false;
  last_ = state.now;
}

void BHV_HoldStation::TrackOffset(const VehicleState& state) {
  if (params_.station == "home" && state.home) {
    offset_W_ = {state.nav.north - state.home->north, state.nav.east - state.home->east};
    return;
  }
  const double elapsed = (state.now - last_.value_or(state.now)).value();
  last_ = state.now;
  const Eigen::Vector3d v_B(state.nav.u, state.nav.v, state.nav.w);
  const Eigen::Vector3d v_W = RotationOf(state.nav.pose()) * v_B;
  offset_W_ += std::clamp(elapsed, 0.0, kLongestStep) * v_W.head<2>();
}

MotionBid BHV_HoldStation::Move(const VehicleState& state) {
  TrackOffset(state);
  const double distance = offset_W_.norm();
  const double radius = params_.radius.value();
  if (is_returning_ && distance < kBack * radius) {
    is_returning_ = false;
    heading_ = state.nav.yaw;
  } else if (distance > radius) {
    is_returning_ = true;
  }
  const double back = std::atan2(-offset_W_.y(), -offset_W_.x());
  const double course = is_returning_ ? back : heading_.value_or(state.nav.yaw);
  const double speed = is_returning_ ? std::min(kApproach * distance, params_.speed.value()) : 0.0;
  return {
      .course = Peak{.summit = course, .flat_half_width = 0.0, .base_half_width = std::numbers::pi},
      .speed = Peak{.summit = speed, .flat_half_width = 0.0, .base_half_width = kSkirt},
      .depth = {},
      .turn_rate = 0.0,
      .warning = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_HoldStation);

}  // namespace limpet
