// SPDX-License-Identifier: MIT
#include "estimation/navigation/pose_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/gps_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"

namespace limpet {
namespace {

constexpr double kSameTime = 1e-3;  // [s] within which two measurements share a node
constexpr int kBelieveFixes = 5;    // refused in a row, then taken after all
constexpr int kBelieveDepths = 20;
constexpr double kGpsGate = 5.0;          // standard deviations
constexpr double kDepthGate = 0.7;        // [m] off the predicted depth that is always believed
constexpr double kDepthGateSigmas = 5.0;  // or so many of its own
constexpr double kStartDepthSigma = 0.05, kStartTiltSigma = 0.01, kLeastYawSigma = 1e-4;

}  // namespace

PoseChain::PoseChain(const NavigatorParams& params, Smoother& smoother,
                     MeasurementBuffer& measurements)
    : params_(params),
      smoother_(smoother),
      measurements_(measurements),
      errors_(params, smoother, measurements.track()),
      fix_gate_(kBelieveFixes),
      depth_gate_(kBelieveDepths) {}

void PoseChain::Begin(double t, const Eigen::Vector2d& p_W) {
  const AttitudeEstimate attitude = measurements_.track().AttitudeAt(t);
  const auto depth = measurements_.depths().Nearest(t);
  NavVector x, sigma;
  x << p_W, depth ? depth->value : 0.0, attitude.yaw, attitude.pitch, attitude.roll;
  const double start = params_.start_sigma.value();
  sigma << start, start, std::max(kStartDepthSigma, 2.0 * params_.depth_sigma.value()),
      std::max(attitude.sd_yaw, kLeastYawSigma), kStartTiltSigma, kStartTiltSigma;
  errors_.Begin(t);
  const int node = smoother_.AddNode(x, std::nullopt);
  times_.push_back(t);
  smoother_.AddTerm(node, Term::OnPose(PosePriorFactor(x, sigma)));
  AddTilt(node, t);
  smoother_.Update();
  p_WD_ = x.head<3>() - measurements_.track().At(t).X_DB.p_WB;
}

bool PoseChain::IsTooLate(double t) const { return t < head_time() - kSameTime; }

double PoseChain::NextKeyframe() const {
  const OdometryTrack& track = measurements_.track();
  const double latest = head_time() + params_.node_period.value();
  const double path = track.PathAt(latest) - track.PathAt(head_time());
  if (path <= params_.node_distance.value()) {
    return latest;
  }
  return head_time() + params_.node_period.value() * params_.node_distance.value() / path;
}

int PoseChain::NodeAt(double t) {
  if (t - head_time() < kSameTime) {
    return size() - 1;
  }
  const double since = head_time();
  Term step = errors_.StepTerm(since, t);  // first: the prediction is with the errors that hold now
  const int node = smoother_.AddNode(Predict(t), std::move(step));
  AddTilt(node, t);
  AddDepth(node, since, t);
  times_.push_back(t);
  smoother_.Update();
  return node;
}

void PoseChain::AddTilt(int node, double t) {
  const AttitudeEstimate attitude = measurements_.track().AttitudeAt(t);
  smoother_.AddTerm(node,
                    Term::OnPose(RollPitchFactor(Radians(attitude.roll), Radians(attitude.pitch),
                                                 params_.tilt_sigma)));
}

void PoseChain::AddDepth(int node, double since, double t) {
  const OdometryTrack& track = measurements_.track();
  const double predicted = smoother_.PoseAt(node)(kNavZ);
  const double z_now = track.At(t).X_DB.p_WB.z();
  const double gate = std::max(kDepthGate, kDepthGateSigmas * params_.depth_sigma.value());
  double sum = 0.0;
  int count = 0;
  for (const ScalarHistory::Sample& depth : measurements_.depths().samples()) {
    if (depth.t <= since || depth.t > t) {
      continue;
    }
    const double carried = depth.value + z_now - track.At(depth.t).X_DB.p_WB.z();
    if (!depth_gate_.Accepts(std::abs(carried - predicted) <= gate)) {
      ++measurements_.counts().depths;
      continue;
    }
    sum += carried;
    ++count;
  }
  if (count > 0) {
    const double sigma = params_.depth_sigma.value() / std::sqrt(std::clamp(t - since, 0.1, 1.0));
    smoother_.AddTerm(node, Term::OnPose(DepthFactor(Meters(sum / count), Meters(sigma))));
  }
}

PoseChain::FixUse PoseChain::AddFix(const PositionFix& fix) {
  if (IsTooLate(fix.t)) {
    ++measurements_.counts().stale_samples;
    return FixUse::kLate;
  }
  const int node = NodeAt(fix.t);
  const NavVector x = smoother_.PoseAt(node);
  const Eigen::MatrixXd covariance = smoother_.Covariance({});
  const double off = (fix.p_W - x.head<2>()).norm();
  const double sd = std::sqrt(covariance(0, 0) + covariance(1, 1) + 2.0 * fix.sd * fix.sd);
  if (!fix_gate_.Accepts(off <= kGpsGate * sd)) {
    ++measurements_.counts().fixes;
    return FixUse::kRefused;
  }
  const Meters sigma =
      GpsFactor::WhiteSigma(Meters(fix.sd), Seconds(fix.t - last_fix_t_), params_.gps_correlation);
  last_fix_t_ = fix.t;
  measurements_.track().NoteFix(fix.t);
  smoother_.AddTerm(node, Term::OnPose(GpsFactor(fix.p_W, sigma)));
  smoother_.Update();
  return FixUse::kTaken;
}

OdometryStep PoseChain::StepTo(double t) const {
  return errors_.Corrected(head_time(), std::max(t, head_time()));
}

NavVector PoseChain::After(const OdometryStep& step, double roll, double pitch) const {
  NavVector x = Head();
  const double c = std::cos(x(kNavYaw)), s = std::sin(x(kNavYaw));
  x(kNavX) += c * step.motion.x() - s * step.motion.y();
  x(kNavY) += s * step.motion.x() + c * step.motion.y();
  x(kNavZ) += step.motion.z();
  x(kNavYaw) += step.motion.w();
  x(kNavPitch) = pitch;
  x(kNavRoll) = roll;
  return x;
}

NavVector PoseChain::Predict(double t) const {
  const AttitudeEstimate attitude = measurements_.track().AttitudeAt(t);
  return After(StepTo(t), attitude.roll, attitude.pitch);
}

Pose PoseChain::DeadReckoned(double t) const {
  Pose pose = measurements_.track().At(t).X_DB;
  pose.p_WB += p_WD_;
  pose.p_WB.z() = Head()(kNavZ) + StepTo(t).motion.z();
  pose.yaw = WrapAngle(pose.yaw);
  return pose;
}

}  // namespace limpet
