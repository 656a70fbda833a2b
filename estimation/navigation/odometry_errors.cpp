// SPDX-License-Identifier: MIT
#include "estimation/navigation/odometry_errors.hpp"

#include <array>
#include <cmath>

#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/bridge_end_factor.hpp"
#include "estimation/smoothing/factors/bridged_step_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/slow_errors_factor.hpp"

namespace limpet {
namespace {

constexpr double kShortDropout = 3.0;    // [s] of which steps bear the error alone
constexpr double kBridgeStretch = 30.0;  // [s] for which current and speed are off by the same
constexpr double kBridgeNoise = 0.01;    // [m/sqrt(s)] that they change in between
constexpr double kEndWait = 2.1;         // [s] after a dropout until its end is known
constexpr int kEnoughAtEnd = 3;          // velocities
constexpr double kLeastSigma = 1e-6;     // of what is not in doubt: a prior needs one
constexpr double kScaleChange = 0.1;     // share of the sigmas, from one period to the next

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
  if (bridge_ && t - bridge_->since < kBridgeStretch) {
    return bridge_->slot;
  }
  const WaterModel& water = track_.water();
  if (bridge_) {
    const int next = smoother_.AddSensorErrors(smoother_.BorderAt(bridge_->slot));
    const SlowErrorsFactor factor(Eigen::Vector3d::Ones(), water.BridgeChange(t - bridge_->since));
    smoother_.AddBorderTerm(bridge_->slot, Term::OnBorder(factor, std::array{bridge_->slot, next}));
    EndBridge();
    bridge_ = Variable{.slot = next, .since = t};
    return next;
  }
  const int slot = smoother_.AddSensorErrors(Eigen::Vector3d::Zero());
  bridge_ = Variable{.slot = slot, .since = t};
  const BorderPriorFactor prior(Eigen::Vector3d::Zero(),
                                water.BridgeCovariance(t, track_.ConductAt(t)));
  smoother_.AddBorderTerm(slot, Term::OnBorder(prior, slot));
  return slot;
}

void OdometryErrors::ConcludeBridge(double t) {
  if (!bridge_) return;
  const auto& end = track_.bridge_end();
  const bool is_of_it = end && end->t >= bridge_->since;
  if (is_of_it && (end->is_open || t < end->t + kEndWait)) return;
  if (is_of_it && end->count >= kEnoughAtEnd) {
    const BridgeEndFactor factor(end->off_H, end->variance_H, end->yaw);
    smoother_.AddBorderTerm(bridge_->slot, Term::OnBorder(factor, bridge_->slot));
  }
  EndBridge();
}

void OdometryErrors::EndBridge() {
  if (bridge_) smoother_.CloseSensorErrors(bridge_->slot);
  bridge_.reset();
}

Term OdometryErrors::StepTerm(double from, double to) {
  OdometryStep step = track_.Between(from, to);
  const auto age = track_.DropoutAge(to);
  if (!age || *age < kShortDropout) {
    ConcludeBridge(to);
    const CalibratedStepFactor factor(step.motion, step.variance, step.duration);
    return mount_ ? Term::OnStep(factor, std::array{SlowAt(to), *mount_})
                  : Term::OnStep(factor, std::array{SlowAt(to)});
  }
  // The error of the guess is one for many steps: it is estimated, and each step alone is good.
  step.motion = Without(step);
  const double changes = kBridgeNoise * kBridgeNoise * step.duration;
  step.variance.head<2>().array() += changes - step.bridge_variance;
  return Term::OnStep(BridgedStepFactor(step.motion, step.variance, step.duration),
                      std::array{BridgeAt(to)});
}

OdometryStep OdometryErrors::Corrected(double from, double to) const {
  OdometryStep step = track_.Between(from, to);
  step.motion = Without(step);
  if (bridge_ && track_.DropoutAge(to)) {
    const double yaw = track_.AttitudeAt(from).yaw;
    step.motion.head<2>() -=
        step.duration * BridgeErrorAhead(smoother_.BorderAt(bridge_->slot), yaw);
  }
  return step;
}

}  // namespace limpet
