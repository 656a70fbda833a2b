// SPDX-License-Identifier: MIT
#include "estimation/navigation/measurement_buffer.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr double kAhead = 5.0;           // [s] of a sensor before the attitude
constexpr double kTurnSpan = 0.2;        // [s] of attitudes that tell how fast the body turns
constexpr double kSinkRateSpan = 1.0;    // [s] of depths that tell the sink rate
constexpr double kAltitudeMaxAge = 1.5;  // [s]
constexpr double kCompassMaxAge = 1.5;   // [s]
constexpr double kDepthMaxAge = 0.6;     // [s] of a depth beside a velocity

}  // namespace

MeasurementBuffer::MeasurementBuffer(const OdometryParams& odometry,
                                     const VelocityGateParams& velocity_gate, Meters depth_sigma)
    : p_dvl_B_(odometry.dvl_B),
      velocity_gate_(velocity_gate),
      track_(odometry),
      agreement_(depth_sigma) {}

void MeasurementBuffer::AddAttitude(const AttitudeEstimate& attitude) {
  const bool is_finite = std::isfinite(attitude.t) && std::isfinite(attitude.roll) &&
                         std::isfinite(attitude.pitch) && std::isfinite(attitude.yaw);
  const bool is_in_order = track_.is_empty() || attitude.t > track_.last_time();
  if (!is_finite || !is_in_order ||
      (!track_.is_empty() &&
       !attitude_gate_.Accepts({.sample = attitude.t, .last = track_.last_time()}))) {
    ++counts_.stale_samples;
    return;
  }
  track_.AddAttitude(attitude);
}

bool MeasurementBuffer::IsPlausible(double t) const {
  return std::isfinite(t) && (track_.is_empty() || t < track_.last_time() + kAhead);
}

Eigen::Matrix3d MeasurementBuffer::LevelRotationAt(double t) const {
  const AttitudeEstimate attitude = track_.AttitudeAt(t);
  return RotationFromRollPitchYaw(attitude.roll, attitude.pitch, attitude.yaw);
}

void MeasurementBuffer::AddSpecificForce(double t, const Eigen::Vector3d& force_B) {
  if (track_.is_empty() || !IsPlausible(t) || !force_B.allFinite()) return;
  felt_.AddForce(t, force_B, LevelRotationAt(t));
}

Eigen::Vector3d MeasurementBuffer::SwingAt(double t) const {
  if (track_.is_empty()) return Eigen::Vector3d::Zero();
  const double before = std::max(t - kTurnSpan, track_.first_time());
  if (t <= before) return Eigen::Vector3d::Zero();
  const Eigen::AngleAxisd turned(LevelRotationAt(before).transpose() * LevelRotationAt(t));
  return (turned.angle() / (t - before) * turned.axis()).cross(p_dvl_B_);
}

VelocityEvidence MeasurementBuffer::EvidenceAt(double t) const {
  if (track_.is_empty()) return {};
  std::optional<Eigen::Vector3d> predicted_B = track_.BridgedAt(t);
  if (predicted_B) *predicted_B -= SwingAt(t);
  return {.predicted_B = predicted_B, .felt_B = felt_.At(t, LevelRotationAt(t))};
}

VelocityGate::Verdict MeasurementBuffer::Judge(double t, const Eigen::Vector3d& v_dvl_B) {
  return velocity_gate_.Judge(t, v_dvl_B - SwingAt(t), EvidenceAt(t));
}

void MeasurementBuffer::AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B) {
  if (!IsPlausible(t) || t <= track_.settled_time()) {
    ++counts_.stale_samples;
    return;
  }
  if (v_dvl_B) CompareVelocity(t, *v_dvl_B);
  using Verdict = VelocityGate::Verdict;
  const Verdict verdict = v_dvl_B ? Judge(t, *v_dvl_B) : Verdict::kRefused;
  const bool is_good = verdict == Verdict::kGood || verdict == Verdict::kBelieved;
  if (is_good && !track_.is_empty()) felt_.Believe(t, *v_dvl_B - SwingAt(t), LevelRotationAt(t));
  counts_.velocities += v_dvl_B && !is_good ? 1 : 0;
  if (const auto rate = is_good ? std::nullopt : depths_.Slope(kSinkRateSpan)) {
    track_.SetSinkRate(*rate);
  }
  track_.AddVelocity(t, is_good ? v_dvl_B : std::nullopt);
  if (verdict == Verdict::kContested) track_.NoteContested(t, *v_dvl_B);
  if (verdict == Verdict::kBelieved) track_.BelieveContested();
  if (verdict == Verdict::kGood && !velocity_gate_.alternative_B()) track_.ForgetContested();
  if (is_good && velocity_gate_.alternative_B()) {
    track_.NoteContested(t, *velocity_gate_.alternative_B() + SwingAt(t));
  }
}

void MeasurementBuffer::CompareVelocity(double t, const Eigen::Vector3d& v_dvl_B) {
  if (track_.is_empty() || !v_dvl_B.allFinite()) return;
  const AttitudeEstimate a = track_.AttitudeAt(t);
  const Eigen::Vector3d v_H = RotationFromRollPitchYaw(a.roll, a.pitch, 0.0) * v_dvl_B;
  const auto depth = depths_.Nearest(t);
  if (depth && std::abs(depth->t - t) < kDepthMaxAge) {
    agreement_.AddDive(t, {.v_down = v_H.z(), .depth = depth->value});
  }
  if (const auto driven_B = track_.ConductAt(t).driven_B) {
    agreement_.AddDrive(t, *driven_B, v_H.head<2>());
  }
}

void MeasurementBuffer::AddAltitude(double t, Meters dvl_altitude) {
  if (track_.is_empty() || !IsPlausible(t) || !std::isfinite(dvl_altitude.value()) ||
      dvl_altitude.value() <= 0.0 || !altitudes_.IsNewest(t)) {
    return;
  }
  altitudes_.Add({t, dvl_altitude.value() + (LevelRotationAt(t) * p_dvl_B_).z()});
  dvl_altitude_t_ = t;
}

void MeasurementBuffer::AddSounding(double t, const Eigen::Vector3d& p_BS, double range) {
  if (track_.is_empty() || !IsPlausible(t) || !altitudes_.IsNewest(t)) return;
  if (t - dvl_altitude_t_ < kAltitudeMaxAge) return;
  const Eigen::Vector3d p_BE = p_BS + Eigen::Vector3d(0.0, 0.0, range);  // of the echo
  altitudes_.Add({t, (LevelRotationAt(t) * p_BE).z()});
}

void MeasurementBuffer::AddDepth(double t, Meters depth) {
  if (!std::isfinite(depth.value()) || !IsPlausible(t) || !depths_.IsNewest(t)) {
    ++counts_.stale_samples;
    return;
  }
  depths_.Add({t, depth.value()});
}

void MeasurementBuffer::AddCompass(double t, Radians off) {
  if (!std::isfinite(off.value()) || !IsPlausible(t) || !compass_.IsNewest(t)) {
    ++counts_.stale_samples;
    return;
  }
  compass_.Add({t, off.value()});
  if (!track_.is_empty()) {
    const double yaw = track_.AttitudeAt(t).yaw;
    agreement_.AddHeadings(t, {.gyro = yaw, .compass = yaw + off.value()});
  }
}

std::optional<double> MeasurementBuffer::CompassAt(double t) const {
  const auto nearest = compass_.Nearest(t);
  if (!nearest || std::abs(nearest->t - t) > kCompassMaxAge) return std::nullopt;
  return WrapAngle(track_.AttitudeAt(t).yaw + nearest->value);
}

void MeasurementBuffer::AddFix(const PositionFix& fix) {
  if (!fix.p_W.allFinite() || !IsPlausible(fix.t) || !(fix.sd > 0.0) ||
      (!fixes_.empty() && fix.t <= fixes_.back().t)) {
    ++counts_.stale_samples;
    return;
  }
  if (!track_.is_empty() && !track_.DropoutAge(fix.t)) {
    agreement_.AddFix(fix.t, fix.p_W, fix.sd, track_.At(fix.t).X_DB.p_WB.head<2>());
  }
  fixes_.push_back(fix);
}

void MeasurementBuffer::AddFrame(const Detections& frame) {
  if (!IsPlausible(frame.exposure.value())) {
    ++counts_.stale_samples;
    return;
  }
  frames_.push_back(frame);
}

void MeasurementBuffer::DropBefore(double t) {
  track_.DropBefore(t);
  depths_.DropBefore(t);
  altitudes_.DropBefore(t);
  compass_.DropBefore(t);
}

std::optional<double> MeasurementBuffer::AltitudeAt(double t) const {
  const auto nearest = altitudes_.Nearest(t);
  if (!nearest || std::abs(nearest->t - t) > kAltitudeMaxAge) return std::nullopt;
  return nearest->value;
}

}  // namespace limpet
