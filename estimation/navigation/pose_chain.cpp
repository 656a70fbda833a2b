// SPDX-License-Identifier: MIT
#include "estimation/navigation/pose_chain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "estimation/smoothing/factors/gps_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr double kSameTime = 1e-3;  // [s] within which two measurements share a node
constexpr int kBelieveDepths = 20;  // refused in a row, then taken after all
constexpr double kLevelSpan = 3.0, kLevelRate = 0.03;  // [s], [m/s] of a vehicle that floats
constexpr double kScaleStep = 1.05;  // of the fixes' sigma, from which on they are weighed anew
constexpr double kEarlierScaleStep = 1.25;  // and those of earlier stays, or of a long one
constexpr std::size_t kFixesPerLesson = 5, kMostToLearnAnew = 300;  // fixes of a stay
constexpr double kLongestReckoning = 15.0;  // [s] that the track reaches back
constexpr double kDepthGate = 0.7;          // [m] off the predicted depth that is always believed
constexpr double kDepthGateSigmas = 5.0;    // or so many of its own
constexpr double kStartDepthSigma = 0.05, kStartTiltSigma = 0.01, kLeastYawSigma = 1e-4;
constexpr double kUnalignedYawSigma = 0.5;  // [rad] beside a compass, which tells it

}  // namespace

PoseChain::PoseChain(const NavigatorParams& params, Smoother& smoother,
                     MeasurementBuffer& measurements)
    : params_(params),
      smoother_(smoother),
      measurements_(measurements),
      errors_(params, smoother, measurements.track()),
      depth_errors_(params, smoother),
      depth_gate_(kBelieveDepths),
      fix_error_(params.gps_correlation) {}

void PoseChain::Begin(double t, const Eigen::Vector2d& p_W) {
  const AttitudeEstimate attitude = measurements_.track().AttitudeAt(t);
  const auto depth = measurements_.depths().Nearest(t);
  NavVector x, sigma;
  x << p_W, depth ? depth->value : 0.0, attitude.yaw, attitude.pitch, attitude.roll;
  const double start = params_.start_sigma.value();
  errors_.Begin(t);
  depth_errors_.Begin(t);
  // A depth whose bias is estimated says the same once more, with its bias.
  const double start_depth = depth && depth_errors_.is_estimated()
                                 ? start
                                 : std::max(kStartDepthSigma, 2.0 * params_.depth_sigma.value());
  const bool is_compass_aside = params_.compass.sigma > Radians(0.0);
  const double yaw_sigma = is_compass_aside ? kUnalignedYawSigma : attitude.sd_yaw;
  sigma << start, start, start_depth, std::max(yaw_sigma, kLeastYawSigma), kStartTiltSigma,
      kStartTiltSigma;
  const int node = smoother_.AddNode(x, std::nullopt);
  times_.push_back(t);
  smoother_.AddTerm(node, Term::OnPose(PosePriorFactor(x, sigma)));
  AddTilt(node, t);
  if (depth && depth_errors_.is_estimated()) {
    smoother_.AddTerm(node, depth_errors_.Measured(t, Meters(depth->value), params_.depth_sigma));
  }
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
  Term step =
      errors_.StepTerm({since, t});  // first: the prediction is with the errors that hold now
  const int node = smoother_.AddNode(Predict(t), std::move(step));
  AddTilt(node, t);
  AddDepth(node, {since, t});
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

void PoseChain::AddDepth(int node, const Interval& span) {
  const auto& [since, t] = span;
  const OdometryTrack& track = measurements_.track();
  const double predicted = smoother_.PoseAt(node)(kNavZ);
  const double z_now = track.At(t).X_DB.p_WB.z();
  const double gate = std::max(kDepthGate, kDepthGateSigmas * params_.depth_sigma.value());
  const double bias = depth_errors_.Bias();
  double sum = 0.0;
  int count = 0;
  for (const ScalarHistory::Sample& depth : measurements_.depths().samples()) {
    if (depth.t <= since || depth.t > t) {
      continue;
    }
    const double carried = depth.value - bias + z_now - track.At(depth.t).X_DB.p_WB.z();
    if (!depth_gate_.Accepts(std::abs(carried - predicted) <= gate)) {
      ++measurements_.counts().depths;
      continue;
    }
    sum += carried;
    ++count;
  }
  if (count > 0) {
    const double sigma = params_.depth_sigma.value() / std::sqrt(std::clamp(t - since, 0.1, 1.0));
    smoother_.AddTerm(node, depth_errors_.Measured(t, Meters(sum / count + bias), Meters(sigma)));
  }
}

PositionFix PoseChain::OfBody(PositionFix fix, int node) const {
  const NavVector x = smoother_.PoseAt(node);
  const Eigen::Matrix3d R_WB = RotationFromRollPitchYaw(x(kNavRoll), x(kNavPitch), x(kNavYaw));
  fix.p_W -= (R_WB * params_.antenna_B).head<2>();
  return fix;
}

PoseChain::FixUse PoseChain::AddFix(const PositionFix& of_antenna) {
  if (IsTooLate(of_antenna.t)) {
    ++measurements_.counts().stale_samples;
    return FixUse::kLate;
  }
  const int node = NodeAt(of_antenna.t);
  const PositionFix fix = OfBody(of_antenna, node);
  const Eigen::Vector2d reckoned_D = measurements_.track().At(fix.t).X_DB.p_WB.head<2>();
  if (consensus_.IsNewStay(fix.t)) BeginStay(fix, reckoned_D);
  const FixConsensus::Verdict verdict =
      consensus_.Add({.fix = fix, .node = node, .off_W = fix.p_W - reckoned_D});
  measurements_.counts().fixes = refused_before_ + static_cast<int>(consensus_.refused());
  if (consensus_.believed().empty()) return FixUse::kRefused;
  LearnFixError(verdict);
  const bool is_old = WeighAnew();
  if (verdict.has_changed_group || is_old) {
    RetakeFixes();
    ReweighEarlierStays();
  } else if (verdict.is_believed) {
    TakeFix(consensus_.believed().back());
  } else {
    return FixUse::kRefused;
  }
  if (auto surfaced =
          verdict.is_believed && IsLevel(fix.t) ? depth_errors_.Surfaced(fix.t) : std::nullopt) {
    smoother_.AddTerm(node, *std::move(surfaced));
  }
  measurements_.track().NoteFix(fix.t);
  measurements_.track().NoteSurface(fix.t);
  smoother_.Update();
  return FixUse::kTaken;
}

bool PoseChain::IsLevel(double t) const {
  const OdometryTrack& track = measurements_.track();
  const double before = std::max(t - kLevelSpan, track.first_time());
  const double sunk = track.At(t).X_DB.p_WB.z() - track.At(before).X_DB.p_WB.z();
  return std::abs(sunk) <= kLevelSpan * kLevelRate;
}

void PoseChain::BeginStay(const PositionFix& first, const Eigen::Vector2d& reckoned_D) {
  refused_before_ = measurements_.counts().fixes;
  before_stay_t_ = last_fix_t_;
  if (!stay_.taken.empty()) earlier_stays_.push_back(std::move(stay_));
  fix_scale_ = fix_error_.Scale();
  stay_ = {.row = {.correlation = params_.gps_correlation.value()}, .scale = fix_scale_};
  std::optional<FixPrediction> prediction;
  std::optional<FixErrorBelief::Start> start;
  if (has_fix_) {
    prediction = FixPrediction{.off_W = Head().head<2>() - reckoned_D,
                               .covariance_W = smoother_.Covariance({}).topLeftCorner<2, 2>()};
    start = FixErrorBelief::Start{.off_W = first.p_W - Head().head<2>(),
                                  .variance = 0.5 * prediction->covariance_W.trace()};
  }
  consensus_.BeginStay(prediction, std::max(fix_scale_, 1.0));
  fix_error_.BeginStay(start);
}

void PoseChain::LearnFixError(const FixConsensus::Verdict& verdict) {
  const std::vector<HeldFix>& fixes = consensus_.believed();
  if (verdict.has_changed_group) {
    fix_error_.RestartStay();
    const std::size_t latest = std::min(fixes.size(), kMostToLearnAnew);
    for (std::size_t i = fixes.size() - latest; i < fixes.size(); ++i)
      LearnFrom(fixes[i], i > 0 ? fixes[i - 1].fix.t : fixes[i].fix.t);
  } else if (verdict.is_believed) {
    LearnFrom(fixes.back(), fixes.size() > 1 ? fixes[fixes.size() - 2].fix.t : fixes.back().fix.t);
  }
}

void PoseChain::LearnFrom(const HeldFix& held, double since) {
  const OdometryTrack& track = measurements_.track();
  const double begin = std::clamp(since, std::min(track.first_time(), held.fix.t), held.fix.t);
  const double drift = track.Between({std::max(begin, held.fix.t - kLongestReckoning), held.fix.t})
                           .variance.head<2>()
                           .mean();
  fix_error_.Add({.t = held.fix.t, .off_W = held.off_W, .sd = held.fix.sd, .drift = drift});
}

bool PoseChain::WeighAnew() {
  const std::size_t fixes = consensus_.believed().size();
  if (fixes % kFixesPerLesson == 0) fix_scale_ = fix_error_.Scale();
  const double sd = consensus_.believed().back().fix.sd, doubt = consensus_.DoubtVariance();
  const double is = std::hypot(fix_scale_, std::sqrt(doubt) / sd);
  const double was = std::hypot(stay_.scale, std::sqrt(stay_.doubt_variance) / sd);
  const double step = fixes > kMostToLearnAnew ? kEarlierScaleStep : kScaleStep;
  if (is <= step * was && is >= was / step) return false;
  stay_.scale = fix_scale_;
  stay_.doubt_variance = doubt;
  return true;
}

void PoseChain::RetakeFixes() {
  for (const TakenFix& fix : stay_.taken)
    smoother_.RemoveTerm(fix.term);
  stay_.taken.clear();
  stay_.row.times.clear();
  for (const HeldFix& held : consensus_.believed()) {
    stay_.taken.push_back({.held = held});
    stay_.row.times.push_back(held.fix.t);
  }
  NoteFixes();
  for (std::size_t i = 0; i < stay_.taken.size(); ++i)
    stay_.taken[i].term = AddFixTerm(stay_, i);
}

void PoseChain::ReweighEarlierStays() {
  for (Stay& stay : earlier_stays_) {
    const double change = fix_scale_ / stay.scale;
    if (change < kEarlierScaleStep && change > 1.0 / kEarlierScaleStep) continue;
    stay.scale = fix_scale_;
    for (std::size_t i = 0; i < stay.taken.size(); ++i) {
      smoother_.RemoveTerm(stay.taken[i].term);
      stay.taken[i].term = AddFixTerm(stay, i);
    }
  }
}

void PoseChain::TakeFix(const HeldFix& held) {
  stay_.taken.push_back({.held = held});
  stay_.row.times.push_back(held.fix.t);
  NoteFixes();
  for (std::size_t i = stay_.row.FirstChangedByTheLast(); i < stay_.taken.size(); ++i) {
    if (i + 1 < stay_.taken.size()) smoother_.RemoveTerm(stay_.taken[i].term);
    stay_.taken[i].term = AddFixTerm(stay_, i);
  }
}

void PoseChain::NoteFixes() {
  has_fix_ = true;
  last_fix_t_ = stay_.row.times.back();
  if (before_stay_t_) stay_.row.gap_before = stay_.row.times.front() - *before_stay_t_;
}

TermId PoseChain::AddFixTerm(const Stay& stay, std::size_t number) {
  const auto& [t, p_W, sd] = stay.taken[number].held.fix;
  const double scaled = std::hypot(stay.scale * sd, std::sqrt(stay.doubt_variance));
  const Meters sigma(scaled / std::sqrt(stay.row.WorthOf(number)));
  return smoother_.AddTerm(stay.taken[number].held.node, Term::OnPose(GpsFactor(p_W, sigma)));
}

OdometryStep PoseChain::StepTo(double t) const {
  return errors_.Corrected({head_time(), std::max(t, head_time())});
}

NavVector PoseChain::After(const OdometryStep& step, const Tilt& tilt) const {
  NavVector x = Head();
  const double c = std::cos(x(kNavYaw)), s = std::sin(x(kNavYaw));
  x(kNavX) += c * step.motion.x() - s * step.motion.y();
  x(kNavY) += s * step.motion.x() + c * step.motion.y();
  x(kNavZ) += step.motion.z();
  x(kNavYaw) += step.motion.w();
  x(kNavPitch) = tilt.pitch;
  x(kNavRoll) = tilt.roll;
  return x;
}

NavVector PoseChain::Predict(double t) const {
  const AttitudeEstimate attitude = measurements_.track().AttitudeAt(t);
  return After(StepTo(t), {.roll = attitude.roll, .pitch = attitude.pitch});
}

Pose PoseChain::DeadReckoned(double t) const {
  Pose pose = measurements_.track().At(t).X_DB;
  pose.p_WB += p_WD_;
  pose.p_WB.z() = Head()(kNavZ) + StepTo(t).motion.z();
  pose.yaw = WrapAngle(pose.yaw);
  return pose;
}

}  // namespace limpet
