// SPDX-License-Identifier: MIT
#include "estimation/attitude/attitude_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "estimation/attitude/time_leap.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/gravity.hpp"

namespace limpet {
namespace {

constexpr double kFogMaxAge = 0.2;    // [s] beyond it the IMU's own z rate serves
constexpr double kLongestStep = 0.5;  // [s] a longer gap is integrated as this much
constexpr int kBelieve = 3;           // samples in a row that were set back

/// Roll and pitch that make `force` the reaction to gravity (0, 0, -g).
Eigen::Vector2d TiltFromForce(const Eigen::Vector3d& force) {
  return {std::atan2(-force.y(), -force.z()),
          std::atan2(force.x(), std::hypot(force.y(), force.z()))};
}

}  // namespace

void AttitudeFilter::AddFogRate(double t, RadiansPerSecond rate) {
  if (std::isfinite(rate.value())) {
    fog_t_ = t;
    fog_rate_ = rate.value();
  }
}

bool AttitudeFilter::is_aligned() const {
  return estimate_ && estimate_->t - start_t_ >= params_.alignment.value();
}

void AttitudeFilter::Start(const InertialInput& input) {
  const double sd = params_.tilt_sigma.value();
  const double bias_sd = params_.gyro_bias_sigma.value();
  x_ << TiltFromForce(input.force_B), 0.0, 0.0;
  P_ = Eigen::Vector4d(sd * sd, sd * sd, bias_sd * bias_sd, bias_sd * bias_sd).asDiagonal();
  start_t_ = aligned_from_ = input.t;
  heading_offset_ = input.heading;
  heading_weight_ = 1.0;
}

bool AttitudeFilter::IsInOrder(const InertialInput& input) {
  if (!estimate_) {
    return true;
  }
  const double dt = input.t - estimate_->t;
  if (dt > kTimeLeap) {
    const bool follows = leaps_ > 0 && std::abs(input.t - leapt_to_) < kLeapAgreement;
    leaps_ = follows ? leaps_ + 1 : 1;
    leapt_to_ = input.t;
    return leaps_ >= kLeapSamples;
  }
  leaps_ = 0;
  set_back_ += dt < 0.0 ? 1 : 0;
  return dt > 0.0;
}

InertialGate::Verdict AttitudeFilter::Judge(const InertialInput& input) {
  // How a vehicle moved while there were no samples nobody knows.
  if (input.t - last_t_ > kLongestStep || set_back_ >= kBelieve) gate_.Forget();
  last_t_ = input.t;
  using Verdict = InertialGate::Verdict;
  const Verdict verdict = gate_.JudgeMotion(input);
  has_heading_ = verdict != Verdict::kRefused && gate_.JudgeHeading(input) != Verdict::kRefused;
  outliers_ += has_heading_ ? 0 : 1;
  return verdict;
}

bool AttitudeFilter::AddInertial(const InertialInput& input) {
  const bool is_finite = std::isfinite(input.t) && input.force_B.allFinite() &&
                         input.rate_B.allFinite() && std::isfinite(input.heading);
  if (!is_finite || !IsInOrder(input)) {
    ++refused_;
    return false;
  }
  using Verdict = InertialGate::Verdict;
  const Verdict verdict = Judge(input);
  if (verdict == Verdict::kRefused) return false;
  leaps_ = 0;
  const bool was_set_back = std::exchange(set_back_, 0) >= kBelieve;
  const bool has_fog = std::abs(input.t - fog_t_) < kFogMaxAge;
  Eigen::Vector3d rate = input.rate_B;
  rate.z() = has_fog ? fog_rate_ : rate.z();
  const bool was_first_false =
      verdict == Verdict::kBelieved && estimate_ && estimate_->t <= start_t_;
  if (!estimate_ || was_first_false) {
    Start(input);
  } else {
    const double gap = input.t - estimate_->t;
    Predict(rate, std::min(gap, kLongestStep));
    AlignHeading(input, was_set_back ? std::max(gap, 2.0 * kLongestStep) : gap);
  }
  CorrectTilt(input, rate.z());

  const double since = input.t - start_t_;
  const double drift = params_.yaw_bias_sigma.value() * since;
  const double walk = params_.yaw_random_walk.value() * std::sqrt(since);
  estimate_ =
      AttitudeEstimate{.t = input.t,
                       .roll = x_(0),
                       .pitch = x_(1),
                       .yaw = WrapAngle(heading_offset_ + yaw_integral_),
                       .yaw_rate = yaw_rate_,
                       .sd_roll = std::hypot(std::sqrt(P_(0, 0)), params_.tilt_floor.value()),
                       .sd_pitch = std::hypot(std::sqrt(P_(1, 1)), params_.tilt_floor.value()),
                       .sd_yaw = std::hypot(params_.heading_sigma.value(), drift, walk)};
  return true;
}

void AttitudeFilter::Predict(const Eigen::Vector3d& rate_B, double dt) {
  const double cr = std::cos(x_(0)), sr = std::sin(x_(0));
  const double cp = std::max(std::cos(x_(1)), 0.05), tp = std::sin(x_(1)) / cp;
  const double p = rate_B.x() - x_(2), q = rate_B.y() - x_(3), r = rate_B.z();
  yaw_rate_ = (q * sr + r * cr) / cp;
  yaw_integral_ += yaw_rate_ * dt;

  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 0) += dt * tp * (q * cr - r * sr);
  F(0, 1) = dt * (q * sr + r * cr) / (cp * cp);
  F(0, 2) = -dt;
  F(0, 3) = -dt * tp * sr;
  F(1, 0) = -dt * (q * sr + r * cr);
  F(1, 3) = -dt * cr;
  x_(0) = WrapAngle(x_(0) + dt * (p + tp * (q * sr + r * cr)));
  x_(1) += dt * (q * cr - r * sr);
  const double noise = params_.gyro_noise.value() * params_.gyro_noise.value() * dt;
  const double walk = params_.gyro_bias_walk.value() * params_.gyro_bias_walk.value() * dt;
  P_ = F * P_ * F.transpose();
  P_.diagonal() += Eigen::Vector4d(noise, noise, walk, walk);
}

void AttitudeFilter::CorrectTilt(const InertialInput& input, double yaw_body_rate) {
  const Eigen::Vector3d rate(input.rate_B.x() - x_(2), input.rate_B.y() - x_(3), yaw_body_rate);
  const Eigen::Vector3d force = input.force_B - rate.cross(v_WB_B_);
  if (std::abs(force.norm() - kGravity) > params_.force_gate) {
    return;  // the vehicle accelerates, or a wave slaps it
  }
  const Eigen::Vector2d tilt = TiltFromForce(force);
  // One tilt is as good as `tilt_sigma` over a second: samples closer in time share their error.
  const double dt = estimate_ ? std::min(input.t - estimate_->t, 1.0) : 1.0;
  const double R = params_.tilt_sigma.value() * params_.tilt_sigma.value() / std::max(dt, 1e-3);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector4d gain = P_.col(axis) / (P_(axis, axis) + R);
    const double residual = axis == 0 ? WrapAngle(tilt(0) - x_(0)) : tilt(1) - x_(1);
    x_ += gain * residual;
    P_ -= (gain * P_.row(axis)).eval();
  }
  P_ = (0.5 * (P_ + P_.transpose())).eval();
}

void AttitudeFilter::AlignHeading(const InertialInput& input, double gap) {
  if (gap > kLongestStep) {
    aligned_from_ = input.t;
    heading_weight_ = 0.0;
  }
  const bool is_first = aligned_from_ <= start_t_;
  if (is_aligned() && (is_first || input.t - aligned_from_ > params_.alignment.value())) {
    return;
  }
  if (!has_heading_) return;
  // What was held up during a gap comes in one go, its times no longer its own: it counts little.
  const double share = gap > kLongestStep ? 0.0 : gap;
  const double weight = is_first ? 1.0 : std::max(share, 1e-6);
  heading_weight_ += weight;
  const double offset = WrapAngle(input.heading - yaw_integral_ - heading_offset_);
  heading_offset_ = WrapAngle(heading_offset_ + offset * weight / heading_weight_);
}

}  // namespace limpet
