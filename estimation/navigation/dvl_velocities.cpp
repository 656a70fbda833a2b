// SPDX-License-Identifier: MIT
#include "estimation/navigation/dvl_velocities.hpp"

#include <algorithm>

#include "limpet/core/long_ago.hpp"

namespace limpet {
namespace {

constexpr double kDropoutAge = 0.5;      // [s] without velocity before it counts as a dropout
constexpr double kDropoutPeriods = 2.4;  // and so many of the DVL's periods

}  // namespace

void DvlVelocities::Add(double t, const std::optional<Eigen::Vector3d>& v_B) {
  const Eigen::Vector3d held_B = rows_ ? rows_->newest.v_B : Eigen::Vector3d::Zero();
  const Row newest{.t = t, .v_B = v_B.value_or(held_B)};
  rows_ = Rows{.before = believed_t_ ? rows_->newest : newest, .newest = newest};
}

Eigen::Vector3d DvlVelocities::At(double t) const {
  if (!rows_) return Eigen::Vector3d::Zero();
  const auto& [before, newest] = *rows_;
  if (t >= newest.t || newest.t <= before.t) return newest.v_B;
  const double share = std::clamp((t - before.t) / (newest.t - before.t), 0.0, 1.0);
  return before.v_B + share * (newest.v_B - before.v_B);
}

double DvlVelocities::LongestPause() const {
  return std::max(kDropoutAge, kDropoutPeriods * period_.value());
}

std::optional<double> DvlVelocities::DropoutAge(double t) const {
  const double age = t - believed_t_.value_or(kLongAgo);
  return age > LongestPause() ? std::optional<double>(age) : std::nullopt;
}

}  // namespace limpet
