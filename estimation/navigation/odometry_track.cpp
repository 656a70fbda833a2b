// SPDX-License-Identifier: MIT
#include "estimation/navigation/odometry_track.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kLongestExtrapolation = 0.3;  // [s]
constexpr double kSinkSigma = 0.1;             // [m/s] of how fast the vehicle sinks, by its depths
constexpr double kTurnMemory = 0.2;            // [s] over which a rate of turning is averaged
constexpr double kAttitudeGap = 2.0;           // [s] in which the vehicle does not turn away
constexpr double kUnknownTurnRate = 0.3;       // [rad/s] 1-sigma of a turn that nobody measures
constexpr double kContestedShare = 0.3;  // 1-sigma of what the track catches up with, as its share
constexpr double kAnyYawVariance = M_PI * M_PI / 3.0;  // [rad^2] of a heading that can be any

Eigen::Matrix3d RotationOf(const AttitudeEstimate& a) {
  return RotationFromRollPitchYaw(a.roll, a.pitch, a.yaw);
}

double Mix(double a, double b, double share) { return a + share * (b - a); }

}  // namespace

SilenceVariance VarianceOfSilence(const OdometryParams& params, double seconds) {
  const double t = std::max(seconds, 0.0);
  const auto of = [t](double rate) { return rate * rate * t * t; };
  return {.horizontal = of(params.unknown_velocity),
          .vertical = of(params.unknown_sink),
          .yaw = std::min(of(kUnknownTurnRate), kAnyYawVariance)};
}

double OdometryTrack::UntrustedSilence(double t) const {
  const double known_t = std::max(
      {velocities_.believed_time().value_or(began_t_), fix_t_.value_or(began_t_), began_t_});
  return std::max(t - known_t - params_.bridge_trusted.value(), 0.0);
}

void OdometryTrack::AddAttitude(const AttitudeEstimate& attitude) {
  Sample sample{.attitude = attitude};
  if (samples_.empty()) {
    sample.R_DB = RotationOf(attitude);
    began_t_ = attitude.t;
  } else {
    const Sample& last = samples_.back();
    if (attitude.t <= last.attitude.t) {
      return;
    }
    sample.attitude.yaw = last.attitude.yaw + WrapAngle(attitude.yaw - last.attitude.yaw);
    sample.R_DB = RotationOf(sample.attitude);
    const double dt = attitude.t - last.attitude.t;
    const double rate = (sample.attitude.yaw - last.attitude.yaw) / dt;
    sample.turn_rate =
        last.turn_rate + (1.0 - std::exp(-dt / kTurnMemory)) * (rate - last.turn_rate);
    Integrate(last, sample);
  }
  samples_.push_back(sample);
}

void OdometryTrack::AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B) {
  if (!velocities_.IsNews(t)) return;
  // A DVL that fell silent is one without lock.
  if (v_dvl_B && velocities_.WasSilentBefore(t)) {
    AddVelocity(t - velocities_.period(), std::nullopt);
  } else {
    velocities_.NotePeriod(t);
  }
  velocities_.Add(t, v_dvl_B);
  if (v_dvl_B) {
    HoldAgainstBridge(t, *v_dvl_B);
    velocities_.BelieveNewest();
    TeachWater(t, *v_dvl_B);
  } else if (const auto bridged_B = BridgedAt(t)) {
    velocities_.BridgeNewest(*bridged_B);
  }
  // What was held since the last row is integrated again with the interpolated velocity.
  const auto is_older = [this](const Sample& s) {
    return s.attitude.t <= velocities_.previous_time();
  };
  auto sample = std::ranges::partition_point(samples_, is_older);
  for (; sample != samples_.end(); ++sample) {
    if (sample != samples_.begin()) {
      Integrate(*std::prev(sample), *sample);
    }
  }
}

void OdometryTrack::NoteContested(double t, const Eigen::Vector3d& v_dvl_B) {
  if (is_empty() || velocities_.empty()) return;
  const Sample sample = SampleAt(t);
  const Eigen::Vector3d off = sample.R_DB * v_dvl_B - LevelVelocity(sample);
  contested_way_ += (t - velocities_.previous_time()) * off.head<2>();
}

void OdometryTrack::BelieveContested() {
  if (is_empty() || velocities_.empty()) return;
  Sample& now = samples_.back();
  now.shift += contested_way_;
  now.p_dvl.head<2>() += contested_way_;
  now.bridge_variance += kContestedShare * kContestedShare * contested_way_.squaredNorm();
  contested_way_.setZero();
  // What the first velocities after a dropout taught was false.
  const auto before = bridge_end_.Reopen(velocities_.newest_time(), Radians(now.attitude.yaw));
  if (before) water_ = *before;
}

void OdometryTrack::ForgetContested() {
  contested_way_.setZero();
  bridge_end_.Close();
}

void OdometryTrack::HoldAgainstBridge(double t, const Eigen::Vector3d& v_dvl_B) {
  if (is_empty()) return;
  const Sample sample = SampleAt(t);
  if (const auto age = DropoutAge(t)) {
    bridge_end_.Begin({.t = t, .length = *age, .yaw = sample.attitude.yaw}, water_);
  }
  bridge_end_.Add(t, (sample.R_DB * v_dvl_B).head<2>(), ConductOf(sample));
}

void OdometryTrack::TeachWater(double t, const Eigen::Vector3d& v_dvl_B) {
  if (is_empty()) return;
  const AttitudeEstimate a = AttitudeAt(t);
  const Eigen::Vector3d v_H = RotationFromRollPitchYaw(a.roll, a.pitch, 0.0) * v_dvl_B;
  water_.Add(t, v_H.head<2>(), ConductAt(t));
}

Eigen::Vector3d OdometryTrack::BridgedVelocity(double t, const Conduct& conduct) const {
  const Eigen::Vector2d v = water_.VelocityAt(t, conduct);
  return {v.x(), v.y(), sink_rate_.value_or(0.0)};
}

std::optional<Eigen::Vector3d> OdometryTrack::BridgedAt(double t) const {
  if (is_empty() || !velocities_.believed_time() || !DropoutAge(t)) return std::nullopt;
  const Sample sample = SampleAt(t);
  return sample.R_DB.transpose() * BridgedVelocity(t, ConductOf(sample));
}

Conduct OdometryTrack::ConductAt(double t) const {
  const auto around = Around(t);
  const double rate = around ? around->after->turn_rate : samples_.back().turn_rate;
  return {.yaw = AttitudeAt(t).yaw, .rate = rate, .driven_B = driven_.At(t)};
}

Conduct OdometryTrack::ConductOf(const Sample& sample) const {
  return {.yaw = sample.attitude.yaw,
          .rate = sample.turn_rate,
          .driven_B = driven_.At(sample.attitude.t)};
}

Eigen::Vector3d OdometryTrack::LevelVelocity(const Sample& sample) const {
  const double t = sample.attitude.t;
  if (!DropoutAge(t)) return sample.R_DB * velocities_.At(t);
  return BridgedVelocity(t, ConductOf(sample));
}

void OdometryTrack::Integrate(const Sample& from, Sample& to) const {
  const double dt = to.attitude.t - from.attitude.t;
  const Eigen::Vector3d moved = 0.5 * dt * (LevelVelocity(from) + LevelVelocity(to));
  to.p_dvl = from.p_dvl + moved;
  to.p_dvl.head<2>() += to.shift;
  to.path = from.path + moved.head<2>().norm();
  to.bridge_variance =
      from.bridge_variance + kContestedShare * kContestedShare * to.shift.squaredNorm();
  auto age = DropoutAge(to.attitude.t);
  if (!age && dt > velocities_.LongestPause()) age = dt;  // the attitude itself was away
  if (age) {
    const double correlated = std::min(*age, params_.bridge_correlation.value());
    to.bridge_variance += 2.0 * water_.VarianceAt(to.attitude.t, ConductOf(to)) * correlated * dt;
  }
  to.stop = age ? from.stop : UntoldStop();
  if (age) {
    const double ahead = dt * water_.HabitualSpeed(to.attitude.t), yaw = to.attitude.yaw;
    to.stop.GoOn({ahead * std::cos(yaw), ahead * std::sin(yaw)}, dt);
  }
  const auto squared = [](double x) { return x * x; };
  const double silent =
      squared(UntrustedSilence(to.attitude.t)) - squared(UntrustedSilence(from.attitude.t));
  const double gap = squared(std::max(dt - kAttitudeGap, 0.0));
  to.unattended = from.unattended + gap;
  to.unknown_way = from.unknown_way + std::max(silent, gap);
}

std::optional<OdometryTrack::Bracket> OdometryTrack::Around(double t) const {
  if (samples_.size() < 2 ||
      !(t > samples_.front().attitude.t && t <= samples_.back().attitude.t)) {
    return std::nullopt;
  }
  // The first sample that is not older; samples come at a steady pace, so it is near this one.
  const double first = samples_.front().attitude.t, last = samples_.back().attitude.t;
  auto next = static_cast<std::size_t>((t - first) / (last - first) *
                                       static_cast<double>(samples_.size() - 1));
  while (samples_[next].attitude.t < t) {
    ++next;
  }
  while (samples_[next - 1].attitude.t >= t) {
    --next;
  }
  const Sample &a = samples_[next - 1], &b = samples_[next];
  return Bracket{&a, &b, (t - a.attitude.t) / (b.attitude.t - a.attitude.t)};
}

AttitudeEstimate OdometryTrack::Between(const Bracket& around, double t) {
  const AttitudeEstimate &a = around.before->attitude, &b = around.after->attitude;
  AttitudeEstimate between = a;
  between.t = t;
  between.roll = Mix(a.roll, b.roll, around.share);
  between.pitch = Mix(a.pitch, b.pitch, around.share);
  between.yaw = Mix(a.yaw, b.yaw, around.share);
  between.yaw_rate = Mix(a.yaw_rate, b.yaw_rate, around.share);
  return between;
}

OdometryTrack::Sample OdometryTrack::SampleAt(double t) const {
  LIMPET_REQUIRE(!samples_.empty(), "no attitude yet");
  if (const auto around = Around(t)) {
    const Sample &a = *around->before, &b = *around->after;
    Sample between{.attitude = Between(*around, t)};
    between.R_DB = RotationOf(between.attitude);
    between.p_dvl = a.p_dvl + around->share * (b.p_dvl - a.p_dvl);
    between.path = Mix(a.path, b.path, around->share);
    between.bridge_variance = Mix(a.bridge_variance, b.bridge_variance, around->share);
    between.unknown_way = Mix(a.unknown_way, b.unknown_way, around->share);
    between.unattended = Mix(a.unattended, b.unattended, around->share);
    between.turn_rate = b.turn_rate;
    between.stop = b.stop;
    return between;
  }
  if (t <= samples_.front().attitude.t) {
    return samples_.front();
  }
  Sample end = samples_.back();
  const double ahead = std::min(t - end.attitude.t, kLongestExtrapolation);
  end.attitude.yaw += end.attitude.yaw_rate * ahead;
  end.attitude.t += ahead;
  end.R_DB = RotationOf(end.attitude);
  Integrate(samples_.back(), end);
  return end;
}

AttitudeEstimate OdometryTrack::AttitudeAt(double t) const {
  const auto around = Around(t);
  return around ? Between(*around, t) : SampleAt(t).attitude;
}

double OdometryTrack::PathAt(double t) const {
  const auto around = Around(t);
  return around ? Mix(around->before->path, around->after->path, around->share) : SampleAt(t).path;
}

TrackPose OdometryTrack::At(double t) const {
  const Sample sample = SampleAt(t);
  const AttitudeEstimate& a = sample.attitude;
  TrackPose pose;
  pose.t = a.t;
  pose.X_DB = {sample.p_dvl - sample.R_DB * params_.dvl_B, a.roll, a.pitch, a.yaw};
  const Eigen::Vector3d rate_B(0.0, 0.0, a.yaw_rate);
  pose.v_B = sample.R_DB.transpose() * LevelVelocity(sample) - rate_B.cross(params_.dvl_B);
  pose.yaw_rate = a.yaw_rate;
  pose.stop_covariance_D = sample.stop.Covariance(water_.StopRate());
  return pose;
}

OdometryStep OdometryTrack::Between(const Interval& span) const {
  const Sample a = SampleAt(span.low), b = SampleAt(span.high);
  const Eigen::Vector3d p_a = a.p_dvl - a.R_DB * params_.dvl_B;
  const Eigen::Vector3d p_b = b.p_dvl - b.R_DB * params_.dvl_B;
  const double cos_yaw = std::cos(a.attitude.yaw), sin_yaw = std::sin(a.attitude.yaw);
  const Eigen::Vector3d moved = p_b - p_a;
  OdometryStep step;
  step.motion << cos_yaw * moved.x() + sin_yaw * moved.y(),
      cos_yaw * moved.y() - sin_yaw * moved.x(), moved.z(), b.attitude.yaw - a.attitude.yaw;
  step.duration = span.high - span.low;
  step.path = b.path - a.path;

  const double white =
      params_.velocity_noise * params_.velocity_noise * velocities_.period() * step.duration;
  const double scale_sigma =
      params_.changing_share * std::hypot(params_.scale_sigma, params_.misalign_sigma);
  const double scale = scale_sigma * scale_sigma * params_.scale_correlation.value() * step.path;
  const double bridge = b.bridge_variance - a.bridge_variance;
  const double yaw_bias = params_.changing_share * params_.yaw_bias;
  const double yaw_rate_variance = params_.yaw_walk * params_.yaw_walk +
                                   yaw_bias * yaw_bias * params_.yaw_bias_correlation.value();
  step.bridge_variance = bridge;
  const auto unknown = [](double speed, double before, double after) {
    return speed * speed * std::max(after - before, 0.0);
  };
  const double xy = white + scale + bridge +
                    unknown(params_.unknown_velocity, a.unknown_way, b.unknown_way) + 1e-6;
  // Attitude errors tilt the track: its depth is worth little, the depth sensor's much, which
  // goes on when there is no velocity.
  const double sunk = kSinkSigma * step.duration;  // in a dropout depths tell how fast it sinks
  const double z = white + std::min(bridge, sunk * sunk) +
                   unknown(params_.unknown_sink, a.unattended, b.unattended) +
                   5e-5 * step.duration + 1e-6;
  step.variance << xy, xy, z, yaw_rate_variance * step.duration + 1e-9;
  return step;
}

void OdometryTrack::DropBefore(double t) {
  while (samples_.size() > 2 && samples_[1].attitude.t < t) {
    samples_.pop_front();
  }
  driven_.DropBefore(t);
}

}  // namespace limpet
