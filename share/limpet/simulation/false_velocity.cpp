// SPDX-License-Identifier: MIT
#include "limpet/simulation/false_velocity.hpp"

#include <cmath>
#include <numbers>

namespace limpet {
namespace {

constexpr double kVerticalSigma = 0.1;  // [m/s]

}  // namespace

FalseVelocity::FalseVelocity(const FalseVelocityParams& params, Random random)
    : params_(params),
      random_(random),
      bursts_({.per_second = params.per_h / 3600.0,
               .shortest = params.shortest,
               .longest = params.longest}) {}

Eigen::Vector3d FalseVelocity::At(Seconds now) {
  if (!bursts_.Contain(now, random_)) return Eigen::Vector3d::Zero();
  if (drawn_ != bursts_.count()) {
    drawn_ = bursts_.count();
    const double way = random_.Uniform(-std::numbers::pi, std::numbers::pi);
    const double speed = random_.Uniform(params_.least.value(), params_.most.value());
    const double down = random_.Normal(kVerticalSigma);
    off_ = {speed * std::cos(way), speed * std::sin(way), down};
  }
  return off_;
}

}  // namespace limpet
