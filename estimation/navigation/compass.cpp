// SPDX-License-Identifier: MIT
#include "estimation/navigation/compass.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/smoothing/factors/compass_factor.hpp"
#include "estimation/smoothing/factors/shared_prior_factor.hpp"

namespace limpet {
namespace {

constexpr int kHeadingsPerLesson = 12;  // headings: a minute
constexpr double kHuber = 1.345;        // beside iron that is not the vehicle's
constexpr double kTooLarge = 2.5;       // believed sigmas
constexpr double kCertainSwing = 3.0;   // sigmas of what is known of it

}  // namespace

void Compass::Begin() {
  sigma_ = std::make_shared<double>(params_.sigma.value());
  slot_ = smoother_->AddSensorErrors(Eigen::Vector3d::Zero());
  for (int i = 0; i < 3; ++i)
    smoother_->AddBorderTerm(*slot_, Term::OnBorder(SharedPriorFactor(i, sigma_), *slot_));
}

void Compass::Use(double t, Radians heading, int node) {
  if (t - used_t_ < params_.period.value()) return;
  used_t_ = t;
  smoother_->AddTerm(node, Term::OnObservation(CompassFactor(heading, params_.noise), *slot_,
                                               Loss::Huber(kHuber)));
  if (++used_ % kHeadingsPerLesson == 0) Learn();
}

void Compass::Learn() {
  const Deviation now = *deviation();
  // The believed sigma counts as one error of that size. What is not known of an error leaves the
  // mean as it is: its variance is the prior's own.
  const double believed = params_.sigma.value();
  const double seen = now.value.squaredNorm() + now.sd.squaredNorm();
  *sigma_ = std::max(believed, std::sqrt((believed * believed + seen) / 4.0));
}

std::optional<Compass::Deviation> Compass::deviation() const {
  if (!slot_) return std::nullopt;
  Deviation now{.value = smoother_->BorderAt(*slot_)};
  const Eigen::MatrixXd covariance = smoother_->Covariance({*slot_});
  now.sd = covariance.diagonal().tail<3>().cwiseMax(0.0).cwiseSqrt();
  now.believed_sd = *sigma_;
  const auto is_too_large = [&](double size, double sd) {
    return size > kTooLarge * params_.sigma.value() && size > kCertainSwing * sd;
  };
  now.is_too_large = is_too_large(std::abs(now.value.x()), now.sd.x()) ||
                     is_too_large(now.value.tail<2>().norm(), now.sd.tail<2>().norm());
  return now;
}

}  // namespace limpet
