// SPDX-License-Identifier: MIT
#include "estimation/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/mrpt_poses.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kBufferLength = 20.0;   // [s] of samples behind the present
constexpr double kLeap = 30.0;           // [s] without attitude that one sample does not prove
constexpr std::size_t kBelieveLeap = 3;  // samples
constexpr double kAhead = 5.0;           // [s] of a sensor before the attitude
constexpr double kDepthPause = 2.0;      // [s] without depth or velocity that sinks nobody

}  // namespace

Navigator::Navigator(const NavigatorParams& params)
    : params_(params),
      gate_(params.velocity_gate),
      track_(params.odometry),
      smoother_(params.smoother),
      tracker_(smoother_, params_.camera, params.objects),
      former_(params.session) {}

void Navigator::AddAttitude(const AttitudeEstimate& attitude) {
  const bool is_finite = std::isfinite(attitude.t) && std::isfinite(attitude.roll) &&
                         std::isfinite(attitude.pitch) && std::isfinite(attitude.yaw);
  if (!is_finite || (!track_.is_empty() && attitude.t <= track_.last_time())) {
    ++counts_.stale_samples;
    return;
  }
  if (!track_.is_empty() && attitude.t - track_.last_time() > kLeap) {
    // A corrupt time must not stop the clock for all that follows; a real gap goes on.
    if (!leaps_.empty() && std::abs(attitude.t - leaps_.back()) > 1.0) leaps_.clear();
    leaps_.push_back(attitude.t);
    if (leaps_.size() < kBelieveLeap) {
      ++counts_.stale_samples;
      return;
    }
  }
  leaps_.clear();
  track_.AddAttitude(attitude);
}

bool Navigator::IsPlausible(double t) const {
  return std::isfinite(t) && (track_.is_empty() || t < track_.last_time() + kAhead);
}

void Navigator::AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B) {
  if (!IsPlausible(t) || t <= track_.settled_time()) {
    ++counts_.stale_samples;
    return;
  }
  const bool is_good = v_dvl_B && gate_.Accepts(t, *v_dvl_B);
  counts_.velocities += v_dvl_B && !is_good ? 1 : 0;
  if (const auto rate = is_good ? std::nullopt : SinkRate()) {
    track_.SetSinkRate(*rate);
  }
  track_.AddVelocity(t, is_good ? v_dvl_B : std::nullopt);
}

std::optional<double> Navigator::SinkRate() const {
  constexpr double kSpan = 1.0;  // [s]
  double count = 0.0, sum_t = 0.0, sum_z = 0.0, sum_tt = 0.0, sum_tz = 0.0;
  for (auto depth = depths_.rbegin(); depth != depths_.rend(); ++depth) {
    const double age = depths_.back().t - depth->t;
    if (age > kSpan) break;
    count += 1.0, sum_t -= age, sum_z += depth->value;
    sum_tt += age * age, sum_tz -= age * depth->value;
  }
  const double spread = count * sum_tt - sum_t * sum_t;
  return count >= 4.0 && spread > 0.0
             ? std::optional<double>((count * sum_tz - sum_t * sum_z) / spread)
             : std::nullopt;
}

void Navigator::AddAltitude(double t, double dvl_altitude) {
  if (track_.is_empty() || !IsPlausible(t) || !std::isfinite(dvl_altitude) || dvl_altitude <= 0.0 ||
      (!altitudes_.empty() && t <= altitudes_.back().t)) {
    return;
  }
  const AttitudeEstimate attitude = track_.AttitudeAt(t);
  const Eigen::Matrix3d R_WB =
      RotationFromRollPitchYaw(attitude.roll, attitude.pitch, attitude.yaw);
  altitudes_.push_back({t, dvl_altitude + (R_WB * params_.odometry.dvl_B).z()});
}

void Navigator::AddDepth(double t, double depth) {
  if (!std::isfinite(depth) || !IsPlausible(t) || (!depths_.empty() && t <= depths_.back().t)) {
    ++counts_.stale_samples;
    return;
  }
  depths_.push_back({t, depth});
}

void Navigator::AddGps(double t, const Eigen::Vector2d& p_W, double sd) {
  if (!p_W.allFinite() || !IsPlausible(t) || !(sd > 0.0) ||
      (!fixes_.empty() && t <= fixes_.back().t)) {
    ++counts_.stale_samples;
    return;
  }
  fixes_.push_back({t, p_W, sd});
}

void Navigator::AddFrame(const FrameDetections& frame) {
  if (!IsPlausible(frame.t)) {
    ++counts_.stale_samples;
    return;
  }
  waiting_.push_back(frame);
}

void Navigator::Advance(double now) {
  if (track_.is_empty()) {
    waiting_.clear();
    return;
  }
  // Velocities that are still to come would change what lies behind the last one.
  const double ready = now - params_.frame_wait.value();
  const double settled = std::max(track_.settled_time(), now - 1.5);
  const double limit = std::min({ready, settled, track_.last_time()});
  StartIfPossible(std::min(now, track_.last_time()));
  if (has_started()) {
    WorkOff(limit);
  }
  const double keep = (has_started() ? head_time() : now) - kBufferLength;
  track_.DropBefore(keep);
  const auto is_old = [keep](const Sample& sample) { return sample.t < keep; };
  depths_.erase(depths_.begin(), std::ranges::find_if_not(depths_, is_old));
  altitudes_.erase(altitudes_.begin(), std::ranges::find_if_not(altitudes_, is_old));
}

SolveReport Navigator::Finish() {
  if (!has_started()) {
    return {};
  }
  WorkOff(track_.last_time());
  SolveReport report = smoother_.Converge();
  tracker_.Refresh();
  if (tracker_.Review()) {
    smoother_.Update();
    report = smoother_.Converge();
    tracker_.Refresh();
  }
  if (tracker_.Conclude()) {
    smoother_.Update();
    report = smoother_.Converge();
  }
  tracker_.Refresh();
  if (former_.has_former()) {
    MatchFormerObjects();
    report = smoother_.Converge();
    tracker_.Refresh();
  }
  ++landmark_version_;
  return report;
}

OdometryStep Navigator::StepTo(double t) const {
  OdometryStep step = track_.Between(head_time(), std::max(t, head_time()));
  step.motion = WithoutSlowErrors(step.motion, step.duration, SlowErrorsNow());
  if (bridge_ >= 0)
    step.motion.head<2>() -= step.duration * smoother_.LandmarkAt(bridge_).head<2>();
  return step;
}

NavVector Navigator::After(const OdometryStep& step, double roll, double pitch) const {
  NavVector x = smoother_.PoseAt(node_count() - 1);
  const double c = std::cos(x(kNavYaw)), s = std::sin(x(kNavYaw));
  x(kNavX) += c * step.motion.x() - s * step.motion.y();
  x(kNavY) += s * step.motion.x() + c * step.motion.y();
  x(kNavZ) += step.motion.z();
  x(kNavYaw) += step.motion.w();
  x(kNavPitch) = pitch;
  x(kNavRoll) = roll;
  return x;
}

NavVector Navigator::Predict(double t) const {
  const AttitudeEstimate attitude = track_.AttitudeAt(t);
  return After(StepTo(t), attitude.roll, attitude.pitch);
}

/// What nobody has measured since the attitude fell silent; of the depth also what neither
/// pressure nor velocity has.
void Navigator::AddSilence(double t, double seconds, NavCovariance& covariance) const {
  const double depth_age = t - (depths_.empty() ? head_time() : depths_.back().t);
  const double sinking = std::min(depth_age, track_.DropoutAge(t).value_or(0.0)) - kDepthPause;
  const SilenceVariance silence = VarianceOfSilence(params_.odometry, seconds);
  covariance(kNavX, kNavX) += silence.horizontal;
  covariance(kNavY, kNavY) += silence.horizontal;
  covariance(kNavZ, kNavZ) +=
      std::max(silence.vertical, VarianceOfSilence(params_.odometry, sinking).vertical);
  covariance(kNavYaw, kNavYaw) += silence.yaw;
}

NavigatorEstimate Navigator::Estimate(double t) const {
  LIMPET_REQUIRE(has_started(), "no pose yet");
  const TrackPose track = track_.At(t);
  const OdometryStep step = StepTo(t);
  NavigatorEstimate estimate{.t = t,
                             .X_WB = PoseOf(After(step, track.X_DB.roll, track.X_DB.pitch)),
                             .v_B = track.v_B,
                             .yaw_rate = track.yaw_rate,
                             .altitude = AltitudeAt(t),
                             .velocity_age = track_.DropoutAge(t)};
  // Levelled pose of the head, then the step: MRPT carries the covariance through the composition.
  NavVector head = smoother_.PoseAt(node_count() - 1), motion = NavVector::Zero();
  head.tail<2>().setZero();
  motion.head<4>() = step.motion;
  NavCovariance motion_covariance = NavCovariance::Zero();
  motion_covariance.diagonal().head<4>() = step.variance;
  auto pdf = MrptPosePdf(head, smoother_.Covariance({}));
  pdf += MrptPosePdf(motion, motion_covariance);
  NavCovariance covariance = CovarianceOf(pdf);
  AddSilence(t, t - track.t, covariance);
  estimate.covariance_p = covariance.topLeftCorner<3, 3>();
  estimate.sd_p = covariance.diagonal().head<3>().cwiseMax(0.0).cwiseSqrt();
  estimate.sd_yaw = std::sqrt(std::max(covariance(kNavYaw, kNavYaw), 0.0));
  return estimate;
}

Pose Navigator::DeadReckoned(double t) const {
  Pose pose = track_.At(t).X_DB;
  pose.p_WB += p_WD_;
  pose.p_WB.z() = smoother_.PoseAt(node_count() - 1)(kNavZ) + StepTo(t).motion.z();
  pose.yaw = WrapAngle(pose.yaw);
  return pose;
}

std::vector<PosedFrame> Navigator::TakeFrames() { return std::exchange(posed_, {}); }

std::vector<const TrackedObject*> Navigator::KnownObjects() const {
  std::vector<const TrackedObject*> objects;
  for (const TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) objects.push_back(&object);
  }
  std::ranges::sort(objects, {}, &TrackedObject::id);
  return objects;
}

Eigen::MatrixXd Navigator::JointCovarianceOf(const std::vector<int>& slots) const {
  const auto n = static_cast<Eigen::Index>(3 * slots.size());
  return smoother_.Covariance(slots).bottomRightCorner(n, n);
}

std::vector<LandmarkEstimate> Navigator::Landmarks() const {
  std::vector<LandmarkEstimate> landmarks;
  for (const TrackedObject* object : KnownObjects()) {
    landmarks.push_back({.id = object->id,
                         .p = object->p,
                         .covariance = JointCovarianceOf({object->slot}),
                         .color = object->Color(),
                         .looks = static_cast<int>(object->looks.size()),
                         .prior_id = object->prior_id});
  }
  return landmarks;
}

Eigen::MatrixXd Navigator::LandmarkCovariance() const {
  std::vector<int> slots;
  for (const TrackedObject* object : KnownObjects()) {
    slots.push_back(object->slot);
  }
  return slots.empty() ? Eigen::MatrixXd() : JointCovarianceOf(slots);
}

std::vector<SmoothedPose> Navigator::Smoothed(int first) const {
  std::vector<SmoothedPose> poses;
  for (int i = first; i < node_count(); ++i) {
    poses.push_back({node_times_[static_cast<std::size_t>(i)], PoseOf(smoother_.PoseAt(i))});
  }
  return poses;
}

}  // namespace limpet
