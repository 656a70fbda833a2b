// SPDX-License-Identifier: MIT
#include "estimation/navigation/odometry_errors.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/bridge_end_factor.hpp"
#include "estimation/smoothing/factors/bridged_step_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/slow_errors_factor.hpp"

namespace limpet {
namespace {

constexpr double kShortDropout = 3.0;       // [s] of which steps bear the error alone
constexpr double kEndWait = 2.1;            // [s] after a dropout until its end is known
constexpr int kEnoughAtEnd = 3;             // velocities
constexpr std::size_t kMostStretches = 18;  // of a dropout, that its end may still change
constexpr std::size_t kShareOfStart = 5;
constexpr double kSurprisingEnd = 16.0;  // squared difference over covariance, of two: 1 in 3000
constexpr double kLeastSigma = 1e-6;     // of what is not in doubt: a prior needs one
constexpr double kScaleChange = 0.1;     // share of the sigmas, from one period to the next

Eigen::Vector3d KeptShares(const BridgeDrift& drift) { return {1.0, 1.0, drift.speed_kept}; }

}  // namespace

void OdometryErrors::Begin(double t) {
  const OdometryParams& odometry = params_.odometry;
  const Eigen::Vector3d sigma(odometry.scale_sigma, odometry.misalign_sigma, odometry.yaw_bias);
  const int slot = smoother_.AddSensorErrors(Eigen::Vector3d::Zero());
  slow_ = Variable{.slot = slot, .since = t};
  const BorderPriorFactor prior(Eigen::Vector3d::Zero(),
                                sigma.cwiseAbs2().asDiagonal().toDenseMatrix());
  smoother_.AddBorderTerm(slot, Term::OnBorder(prior, slot));
  BeginMount();
}

void OdometryErrors::BeginMount() {
  const OdometryParams& odometry = params_.odometry;
  if (odometry.gyro_scale_sigma <= 0.0 && odometry.dvl_lever_sigma <= 0.0) return;
  const Eigen::Vector3d sigma(odometry.gyro_scale_sigma, odometry.dvl_lever_sigma,
                              odometry.dvl_lever_sigma);
  mount_ = smoother_.AddSensorErrors(Eigen::Vector3d::Zero());
  const BorderPriorFactor prior(
      Eigen::Vector3d::Zero(),
      sigma.cwiseMax(kLeastSigma).cwiseAbs2().asDiagonal().toDenseMatrix());
  smoother_.AddBorderTerm(*mount_, Term::OnBorder(prior, *mount_));
}

Eigen::Vector4d OdometryErrors::Without(const OdometryStep& step) const {
  return WithoutMountErrors(WithoutSlowErrors(step.motion, step.duration, Now()), Mount());
}

int OdometryErrors::SlowAt(double t) {
  const double age = t - slow_->since;
  if (age < params_.errors_period.value()) {
    return slow_->slot;
  }
  const OdometryParams& odometry = params_.odometry;
  const double keep = std::exp(-age / params_.yaw_bias_memory.value());
  const double change = std::sqrt(1.0 - keep * keep) * odometry.yaw_bias;
  const SlowErrorsFactor factor({1.0, 1.0, keep}, {kScaleChange * odometry.scale_sigma,
                                                   kScaleChange * odometry.misalign_sigma, change});
  const int next = smoother_.AddSensorErrors(Now());
  smoother_.AddBorderTerm(slow_->slot, Term::OnBorder(factor, std::array{slow_->slot, next}));
  smoother_.CloseSensorErrors(slow_->slot);
  slow_ = Variable{.slot = next, .since = t};
  return next;
}

int OdometryErrors::BridgeAt(double t) {
  const WaterModel& water = track_.water();
  const Conduct conduct = track_.ConductAt(t);
  if (bridge_.empty()) {
    BeginStretch(
        {.slot = smoother_.AddSensorErrors(Eigen::Vector3d::Zero()), .since = t, .began = conduct});
    bridge_start_ = water.BridgeCovariance(t, conduct);
    const int slot = bridge_.back().slot;
    const BorderPriorFactor prior(Eigen::Vector3d::Zero(), *bridge_start_);
    smoother_.AddBorderTerm(slot, Term::OnBorder(prior, slot));
    return slot;
  }
  Stretch& now = bridge_.back();
  if (t - now.since < water.BridgeStretch(now.began, conduct)) return now.slot;
  now.drift = water.BridgeChange(t - now.since, now.began, conduct);
  const Eigen::Vector3d goes_on = KeptShares(now.drift).cwiseProduct(smoother_.BorderAt(now.slot));
  BeginStretch({.slot = smoother_.AddSensorErrors(goes_on), .since = t, .began = conduct});
  const std::size_t before = bridge_.size() - 2;
  smoother_.AddBorderTerm(bridge_[before].slot, TermToNext(before, Eigen::Vector3d::Zero()));
  return bridge_.back().slot;
}

void OdometryErrors::BeginStretch(const Stretch& stretch) {
  bridge_.push_back(stretch);
  if (bridge_.size() <= kMostStretches) return;
  smoother_.CloseSensorErrors(bridge_.front().slot);
  bridge_.pop_front();
  bridge_start_.reset();
}

Term OdometryErrors::TermToNext(std::size_t stretch, const Eigen::Vector3d& besides) const {
  const auto& [slot, since, began, drift] = bridge_[stretch];
  const Eigen::Vector3d change(drift.current_change, drift.current_change, drift.speed_change);
  const SlowErrorsFactor factor(KeptShares(drift), (change.cwiseAbs2() + besides).cwiseSqrt());
  return Term::OnBorder(factor, std::array{slot, bridge_[stretch + 1].slot});
}

void OdometryErrors::ConcludeBridge(double t) {
  if (bridge_.empty()) return;
  const auto& end = track_.bridge_end();
  const bool is_of_it = end && end->t >= bridge_.back().since;
  if (is_of_it && (end->is_open || t < end->t + kEndWait)) return;
  if (is_of_it && end->count >= kEnoughAtEnd) UseEnd(*end);
  EndBridge();
}

// An end that the bridge does not explain: the vehicle has changed its way, nobody knows when. A
// change at any time of the dropout, each as likely, is off by half of it in the mean, with a
// 1-sigma of its 12th part's root. Changes that are spread evenly over the dropout have just these;
// a single stretch, with a sixth of its square at either end.
void OdometryErrors::UseEnd(const BridgeEnd& end) {
  const int slot = bridge_.back().slot;
  BridgeEndFactor factor(end.off_H, end.variance_H, end.yaw);
  BridgeEndFactor::BorderJacobian J;
  const Eigen::Vector2d sigma = end.variance_H.cwiseSqrt();
  const Eigen::Vector2d surprise = -factor.Evaluate(smoother_.BorderAt(slot), &J);
  const Eigen::Matrix3d known = smoother_.Covariance({slot}).bottomRightCorner<3, 3>();
  const Eigen::Matrix2d expected = J * known * J.transpose() + Eigen::Matrix2d::Identity();
  if (surprise.dot(expected.inverse() * surprise) > kSurprisingEnd) {
    const Eigen::Vector2d change = surprise.cwiseProduct(sigma).cwiseAbs2() /
                                   static_cast<double>(bridge_.size() + kShareOfStart);
    WidenBridge({change.y(), change.y(), change.x()});
    factor = BridgeEndFactor(end.off_H, end.variance_H + change, end.yaw);
  }
  smoother_.AddBorderTerm(slot, Term::OnBorder(factor, slot));
}

void OdometryErrors::WidenBridge(const Eigen::Vector3d& variance) {
  for (std::size_t i = 0; i < bridge_.size(); ++i) {
    const int slot = bridge_[i].slot;
    std::vector<Term> terms;
    if (i == 0 && bridge_start_) {
      const Eigen::Matrix3d wider = *bridge_start_ + variance.asDiagonal().toDenseMatrix();
      terms.push_back(Term::OnBorder(BorderPriorFactor(Eigen::Vector3d::Zero(), wider), slot));
    }
    if (i + 1 < bridge_.size()) terms.push_back(TermToNext(i, variance));
    smoother_.SetBorderTerms(slot, std::move(terms));
  }
}

void OdometryErrors::EndBridge() {
  for (const Stretch& stretch : bridge_)
    smoother_.CloseSensorErrors(stretch.slot);
  bridge_.clear();
  bridge_start_.reset();
}

Term OdometryErrors::StepTerm(const Interval& span) {
  OdometryStep step = track_.Between(span);
  const auto age = track_.DropoutAge(span.high);
  if (!age || *age < kShortDropout) {
    ConcludeBridge(span.high);
    const CalibratedStepFactor factor(step.motion, step.variance, step.duration);
    return mount_ ? Term::OnStep(factor, std::array{SlowAt(span.high), *mount_})
                  : Term::OnStep(factor, std::array{SlowAt(span.high)});
  }
  // The error of the guess is one for many steps: it is estimated, and each step alone is good.
  step.motion = Without(step);
  const double noise = track_.water().BridgeNoise(track_.ConductAt(span.high));
  const double changes = noise * noise * step.duration;
  step.variance.head<2>().array() += changes - step.bridge_variance;
  return Term::OnStep(BridgedStepFactor(step.motion, step.variance, step.duration),
                      std::array{BridgeAt(span.high)});
}

OdometryStep OdometryErrors::Corrected(const Interval& span) const {
  OdometryStep step = track_.Between(span);
  step.motion = Without(step);
  if (!bridge_.empty() && track_.DropoutAge(span.high)) {
    const double yaw = track_.AttitudeAt(span.low).yaw;
    step.motion.head<2>() -=
        step.duration * BridgeErrorAhead(smoother_.BorderAt(bridge_.back().slot), yaw);
  }
  return step;
}

}  // namespace limpet
