// SPDX-License-Identifier: MIT
#include "estimation/navigation/bridge_end.hpp"

#include <Eigen/Geometry>

namespace limpet {
namespace {

constexpr double kOpenEnd = 15.0;   // [s] after a dropout in which its end may be another one
constexpr double kBridgeEnd = 2.0;  // [s] of velocities that a bridge is held against

}  // namespace

void BridgeEndCheck::Begin(const BridgeEnd& end, const WaterModel& bridged_by) {
  if (end_ && end_->is_open && end.t - end_->t <= kOpenEnd) return;
  bridged_by_ = bridged_by;
  end_ = end;
}

void BridgeEndCheck::Add(double t, const Eigen::Vector2d& v_D, const Conduct& conduct) {
  if (!end_ || t - end_->t > kBridgeEnd) return;
  const Eigen::Vector2d bridged = bridged_by_->VelocityAt(t, conduct);
  BridgeEnd& end = *end_;
  ++end.count;
  end.off_H += (Eigen::Rotation2Dd(-conduct.yaw) * (bridged - v_D) - end.off_H) / end.count;
  const double white = velocity_noise_ * velocity_noise_ / end.count;
  end.variance_H = bridged_by_->EndVariance(end.length, conduct).array() + white;
}

std::optional<WaterModel> BridgeEndCheck::Reopen(double t, Radians yaw) {
  if (!end_ || t - end_->t > kOpenEnd) return std::nullopt;
  end_ =
      BridgeEnd{.t = t, .length = end_->length + t - end_->t, .yaw = yaw.value(), .is_open = true};
  return bridged_by_;
}

}  // namespace limpet
