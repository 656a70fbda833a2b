// SPDX-License-Identifier: MIT
#include "estimation/navigation/inertial_velocity.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/core/gravity.hpp"

namespace limpet {
namespace {

constexpr double kGood = 1.5;         // [s] in which a bias of 0.05 m/s^2 makes half a jump
constexpr double kLongestGap = 0.15;  // [s] between forces: what happened in one is not known
constexpr double kKept = 4.0;         // [s] of forces: velocities come late

}  // namespace

void InertialVelocity::AddForce(double t, const Eigen::Vector3d& force_B,
                                const Eigen::Matrix3d& R_DB) {
  if (!samples_.empty() && t <= samples_.back().t) return;
  if (!samples_.empty() && t - samples_.back().t > kLongestGap) samples_.clear();
  const Eigen::Vector3d acceleration_D = R_DB * force_B + Eigen::Vector3d(0.0, 0.0, kGravity);
  Sample next{.t = t, .acceleration_D = acceleration_D};
  if (!samples_.empty()) {
    const Sample& last = samples_.back();
    next.gained_D = last.gained_D + 0.5 * (t - last.t) * (last.acceleration_D + acceleration_D);
  }
  samples_.push_back(next);
  while (samples_.front().t < t - kKept)
    samples_.pop_front();
}

void InertialVelocity::Believe(double t, const Eigen::Vector3d& v_B, const Eigen::Matrix3d& R_DB) {
  believed_ = Believed{.t = t, .v_D = R_DB * v_B};
}

std::optional<Eigen::Vector3d> InertialVelocity::GainedAt(double t) const {
  if (samples_.empty() || t < samples_.front().t || t > samples_.back().t + kLongestGap) {
    return std::nullopt;
  }
  const auto after = std::ranges::upper_bound(samples_, t, {}, &Sample::t);
  const Sample& before = *std::prev(after);
  return before.gained_D + (t - before.t) * before.acceleration_D;
}

std::optional<Eigen::Vector3d> InertialVelocity::At(double t, const Eigen::Matrix3d& R_DB) const {
  if (!believed_ || t < believed_->t || t - believed_->t > kGood) return std::nullopt;
  const auto from = GainedAt(believed_->t), to = GainedAt(t);
  if (!from || !to) return std::nullopt;
  return R_DB.transpose() * (believed_->v_D + *to - *from);
}

}  // namespace limpet
