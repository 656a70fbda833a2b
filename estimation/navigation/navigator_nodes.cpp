// SPDX-License-Identifier: MIT
// How the navigator's chain grows: which pose gets a node, and which terms.
#include <algorithm>
#include <cmath>

#include "estimation/navigation/navigator.hpp"
#include "estimation/smoothing/factors/bridged_step_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/gps_factor.hpp"
#include "estimation/smoothing/factors/landmark_prior_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/slow_errors_factor.hpp"

namespace limpet {
namespace {

constexpr double kSameTime = 1e-3;       // [s] within which two measurements share a node
constexpr double kNever = 1e18;          // [s]
constexpr double kAltitudeMaxAge = 1.5;  // [s]
constexpr double kReviewPeriod = 1.0;    // [s]
constexpr int kBelieveRefused = 5;       // measurements refused in a row, then taken after all
constexpr double kGpsGate = 5.0;         // standard deviations
constexpr double kShortDropout = 3.0;    // [s] of which steps bear the error alone
constexpr double kBridgeStretch = 60.0;  // [s] for which the bridged velocity is off by the same
constexpr double kBridgeNoise = 0.02;    // [m/sqrt(s)] that it changes in between
constexpr double kDepthGate = 0.7;       // [m] off the predicted depth

}  // namespace

void Navigator::StartIfPossible(double limit) {
  if (has_started()) {
    return;
  }
  const double begin = track_.first_time();
  while (!fixes_.empty() && fixes_.front().t < begin) {
    fixes_.pop_front();
  }
  if (!fixes_.empty() && fixes_.front().t <= limit) {
    Start(fixes_.front().t, fixes_.front().p_W);
    return;
  }
  if (first_time_ < 0.0) {
    first_time_ = begin;
  }
  if (params_.fix_wait.value() > 0.0 && limit - first_time_ > params_.fix_wait.value()) {
    Start(begin, Eigen::Vector2d::Zero());
  }
}

void Navigator::Start(double t, const Eigen::Vector2d& p_W) {
  const AttitudeEstimate attitude = track_.AttitudeAt(t);
  const auto depth = std::ranges::min_element(
      depths_, {}, [t](const Sample& sample) { return std::abs(sample.t - t); });
  const double z = depth == depths_.end() ? 0.0 : depth->value;
  NavVector x, sigma;
  x << p_W, z, attitude.yaw, attitude.pitch, attitude.roll;
  const double start = params_.start_sigma.value();
  constexpr double kDepthSigma = 0.05, kTiltSigma = 0.01;
  sigma << start, start, kDepthSigma, std::max(attitude.sd_yaw, 1e-4), kTiltSigma, kTiltSigma;
  const OdometryParams& odometry = params_.odometry;
  const Eigen::Vector3d slow(odometry.scale_sigma, odometry.misalign_sigma, odometry.yaw_bias);
  errors_ = smoother_.AddErrors(Eigen::Vector3d::Zero());
  errors_since_ = t;
  smoother_.AddLandmarkTerm(
      errors_, Term::OnLandmark(LandmarkPriorFactor(Eigen::Vector3d::Zero(),
                                                    slow.cwiseAbs2().asDiagonal().toDenseMatrix()),
                                errors_));
  const int node = smoother_.AddNode(x, std::nullopt);
  node_times_.push_back(t);
  smoother_.AddTerm(node, Term::OnPose(PosePriorFactor(x, sigma)));
  AddTilt(node, t);
  smoother_.Update();
  p_WD_ = x.head<3>() - track_.At(t).X_DB.p_WB;
}

double Navigator::NextKeyframe() const {
  const double latest = head_time() + params_.node_period.value();
  const double path = track_.PathAt(latest) - track_.PathAt(head_time());
  if (path <= params_.node_distance.value()) {
    return latest;
  }
  return head_time() + params_.node_period.value() * params_.node_distance.value() / path;
}

void Navigator::WorkOff(double limit) {
  std::ranges::stable_sort(waiting_, {}, &FrameDetections::t);
  auto frame = waiting_.begin();
  while (true) {
    const double fix_t = fixes_.empty() ? kNever : fixes_.front().t;
    const double frame_t = frame == waiting_.end() ? kNever : frame->t;
    const double keyframe_t = NextKeyframe();
    if (std::min({fix_t, frame_t, keyframe_t}) > limit) {
      break;
    }
    if (fix_t <= std::min(frame_t, keyframe_t)) {
      TakeFix(fixes_.front());
      fixes_.pop_front();
    } else if (frame_t <= keyframe_t) {
      TakeFrame(*frame);
      ++frame;
    } else {
      NodeAt(keyframe_t);
    }
  }
  waiting_.erase(waiting_.begin(), frame);
}

int Navigator::NodeAt(double t) {
  if (t - head_time() < kSameTime) {
    return node_count() - 1;
  }
  const double since = head_time();
  const int node = smoother_.AddNode(Predict(t), StepTerm(t));
  AddTilt(node, t);
  AddDepthTerm(node, since, t);
  node_times_.push_back(t);
  smoother_.Update();
  tracker_.Refresh();
  return node;
}

int Navigator::ErrorsAt(double t) {
  const double age = t - errors_since_;
  if (age < params_.errors_period.value()) {
    return errors_;
  }
  const OdometryParams& odometry = params_.odometry;
  const double keep = std::exp(-age / params_.yaw_bias_memory.value());
  const double change = std::sqrt(1.0 - keep * keep) * odometry.yaw_bias;
  constexpr double kScaleChange = 0.1;  // share of their sigmas, from one period to the next
  const SlowErrorsFactor factor({1.0, 1.0, keep}, {kScaleChange * odometry.scale_sigma,
                                                   kScaleChange * odometry.misalign_sigma, change});
  const int next = smoother_.AddErrors(smoother_.LandmarkAt(errors_));
  smoother_.AddLandmarkTerm(errors_, Term::OnBlocks(factor, errors_, next));
  smoother_.CloseErrors(errors_);
  errors_ = next;
  errors_since_ = t;
  return errors_;
}

int Navigator::BridgeAt(double t, double age) {
  if (bridge_ >= 0 && t - bridge_since_ < kBridgeStretch) {
    return bridge_;
  }
  EndBridge();
  bridge_ = smoother_.AddErrors(Eigen::Vector3d::Zero());
  bridge_since_ = t;
  const double variance = std::pow(track_.BridgeSigma(age + kBridgeStretch), 2);
  const LandmarkPriorFactor prior(Eigen::Vector3d::Zero(), variance * Eigen::Matrix3d::Identity());
  smoother_.AddLandmarkTerm(bridge_, Term::OnLandmark(prior, bridge_));
  return bridge_;
}

void Navigator::EndBridge() {
  if (bridge_ >= 0) smoother_.CloseErrors(bridge_);
  bridge_ = -1;
}

Term Navigator::StepTerm(double t) {
  OdometryStep step = track_.Between(head_time(), t);
  const auto age = track_.DropoutAge(t);
  if (!age || *age < kShortDropout) {
    EndBridge();
    return Term::OnStep(CalibratedStepFactor(step.motion, step.variance, step.duration),
                        ErrorsAt(t));
  }
  // The error of the guess is one for many steps: it is estimated, and each step alone is good.
  step.motion = WithoutSlowErrors(step.motion, step.duration, SlowErrorsNow());
  const double changes = kBridgeNoise * kBridgeNoise * step.duration;
  step.variance.head<2>().array() += changes - step.bridge_variance;
  return Term::OnStep(BridgedStepFactor(step.motion, step.variance, step.duration),
                      BridgeAt(t, *age));
}

void Navigator::AddTilt(int node, double t) {
  const AttitudeEstimate attitude = track_.AttitudeAt(t);
  smoother_.AddTerm(node,
                    Term::OnPose(RollPitchFactor(Radians(attitude.roll), Radians(attitude.pitch),
                                                 params_.tilt_sigma)));
}

void Navigator::AddDepthTerm(int node, double since, double t) {
  const double predicted = smoother_.PoseAt(node)(kNavZ);
  const double z_now = track_.At(t).X_DB.p_WB.z();
  double sum = 0.0;
  int count = 0;
  for (const Sample& depth : depths_) {
    if (depth.t <= since || depth.t > t) {
      continue;
    }
    const double carried = depth.value + z_now - track_.At(depth.t).X_DB.p_WB.z();
    if (std::abs(carried - predicted) > kDepthGate && ++refused_depths_ < kBelieveRefused * 4) {
      ++counts_.depths;
      continue;
    }
    refused_depths_ = 0;
    sum += carried;
    ++count;
  }
  if (count > 0) {
    const double sigma = params_.depth_sigma.value() / std::sqrt(std::clamp(t - since, 0.1, 1.0));
    smoother_.AddTerm(node, Term::OnPose(DepthFactor(Meters(sum / count), Meters(sigma))));
  }
}

void Navigator::TakeFix(const Fix& fix) {
  if (fix.t < head_time() - kSameTime) {
    ++counts_.stale_samples;
    return;
  }
  const int node = NodeAt(fix.t);
  const NavVector x = smoother_.PoseAt(node);
  const Eigen::MatrixXd covariance = smoother_.Covariance({});
  const double off = (fix.p_W - x.head<2>()).norm();
  const double sd = std::sqrt(covariance(0, 0) + covariance(1, 1) + 2.0 * fix.sd * fix.sd);
  if (off > kGpsGate * sd && ++refused_fixes_ < kBelieveRefused) {
    ++counts_.fixes;
    return;
  }
  refused_fixes_ = 0;
  const Meters sigma =
      GpsFactor::WhiteSigma(Meters(fix.sd), Seconds(fix.t - last_fix_t_), params_.gps_correlation);
  last_fix_t_ = fix.t;
  track_.NoteFix(fix.t);
  smoother_.AddTerm(node, Term::OnPose(GpsFactor(fix.p_W, sigma)));
  smoother_.Update();
  tracker_.Refresh();
  ++landmark_version_;  // a fix after a dive moves them all
}

void Navigator::TakeFrame(const FrameDetections& frame) {
  if (frame.t < head_time() - kSameTime) {
    ++counts_.late_frames;
    return;
  }
  const bool has_usable = std::ranges::any_of(
      frame.boxes, [this](const BoxDetection& box) { return tracker_.IsUsable(box); });
  TrackerFrame seen{.detections = &frame,
                    .x = NavVector::Zero(),
                    .node = has_usable ? NodeAt(frame.t) : -1,
                    .path = track_.PathAt(frame.t),
                    .altitude = AltitudeAt(frame.t)};
  seen.x = has_usable ? smoother_.PoseAt(seen.node) : Predict(frame.t);
  std::vector<int> landmarks = tracker_.Process(seen);
  bool has_changed = has_usable;
  if (has_usable) {
    smoother_.Update();
    tracker_.Refresh();
    needs_review_ = true;
  }
  if (needs_review_ && frame.t - last_review_t_ > kReviewPeriod) {
    ReviewObjects(frame.t);
    has_changed = true;
  }
  const NavVector x = has_changed ? Predict(frame.t) : seen.x;
  posed_.push_back({frame, PoseOf(x), seen.altitude, std::move(landmarks)});
}

void Navigator::ReviewObjects(double t) {
  last_review_t_ = t;
  needs_review_ = false;
  ++landmark_version_;
  if (tracker_.Review()) {
    smoother_.Update();
    tracker_.Refresh();
    needs_review_ = true;
  }
  MatchFormerObjects();
}

std::optional<double> Navigator::AltitudeAt(double t) const {
  const auto after = std::ranges::lower_bound(altitudes_, t, {}, &Sample::t);
  auto nearest = after;
  if (after != altitudes_.begin() &&
      (after == altitudes_.end() || t - std::prev(after)->t <= after->t - t)) {
    nearest = std::prev(after);
  }
  if (nearest == altitudes_.end() || std::abs(nearest->t - t) > kAltitudeMaxAge) {
    return std::nullopt;
  }
  return nearest->value;
}

}  // namespace limpet
