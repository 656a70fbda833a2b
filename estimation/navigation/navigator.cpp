// SPDX-License-Identifier: MIT
#include "estimation/navigation/navigator.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>

#include "estimation/navigation/aiding_sources.hpp"

namespace limpet {
namespace {

constexpr double kBufferLength = 20.0;  // [s] of samples behind the present
constexpr double kVelocityWait = 1.5;   // [s] that the chain waits for a velocity
constexpr double kNever = 1e18;         // [s]
constexpr double kReviewPeriod = 1.0;   // [s]
constexpr int kLastRounds = 4;          // of review, when nothing more is to come

std::vector<int> SlotsOf(const std::vector<const TrackedObject*>& objects) {
  std::vector<int> slots;
  for (const TrackedObject* object : objects)
    slots.push_back(object->slot());
  return slots;
}

}  // namespace

Navigator::Navigator(const NavigatorParams& params)
    : params_(params),
      measurements_(params.odometry, params.velocity_gate, params.depth_sigma),
      smoother_(params.smoother),
      tracker_(smoother_, params_.camera, params.objects),
      chain_(params_, smoother_, measurements_),
      compass_(params_.compass, smoother_),
      box_motion_(params_.camera),
      former_(params.session, smoother_, tracker_),
      aiding_(std::make_unique<AidingSources>(smoother_)) {}

Navigator::~Navigator() = default;

int Navigator::AddSource(std::unique_ptr<MeasurementSource> source) {
  return aiding_->Add(std::move(source));
}

void Navigator::AddObservation(int source, std::shared_ptr<mrpt::obs::CObservation> seen) {
  if (const auto seabed = aiding_->source(source).SeabedOf(*seen)) {
    measurements_.AddSounding(mrpt::Clock::toDouble(seen->timestamp), seabed->p_BS, seabed->range);
    aiding_->NoteTaken(source);
    return;
  }
  aiding_->Keep(source, std::move(seen));
}

std::optional<double> Navigator::attitude_time() const {
  const OdometryTrack& track = measurements_.track();
  return track.is_empty() ? std::nullopt : std::optional(track.last_time());
}

void Navigator::Advance(double now) {
  const OdometryTrack& track = measurements_.track();
  if (track.is_empty()) {
    measurements_.frames().clear();
    return;
  }
  // Velocities that are still to come would change what lies behind the last one.
  const double ready = now - params_.frame_wait.value();
  const double settled =
      std::max(track.settled_time().value_or(now - kVelocityWait), now - kVelocityWait);
  const double limit = std::min({ready, settled, track.last_time()});
  StartIfPossible(std::min(now, track.last_time()));
  if (has_started()) {
    WorkOff(limit);
  }
  measurements_.DropBefore((has_started() ? chain_.head_time() : now) - kBufferLength);
}

void Navigator::StartIfPossible(double limit) {
  if (has_started()) {
    return;
  }
  const double begin = measurements_.track().first_time();
  std::deque<PositionFix>& fixes = measurements_.fixes();
  while (!fixes.empty() && fixes.front().t < begin)
    fixes.pop_front();
  if (!fixes.empty() && fixes.front().t <= limit) {
    Begin(fixes.front().t, fixes.front().p_W);
    return;
  }
  if (!first_time_) first_time_ = begin;
  if (params_.fix_wait.value() > 0.0 && limit - *first_time_ > params_.fix_wait.value()) {
    Begin(begin, Eigen::Vector2d::Zero());
  }
}

void Navigator::Begin(double t, const Eigen::Vector2d& p_W) {
  chain_.Begin(t, p_W);
  aiding_->Begin();
  if (!compass_.is_in_use()) return;
  compass_.Begin();
  UseCompass(t, 0);
  smoother_.Update();
}

void Navigator::UseCompass(double t, int node) {
  if (!compass_.is_in_use()) return;
  if (const auto heading = measurements_.CompassAt(t)) compass_.Use(t, Radians(*heading), node);
}

void Navigator::WorkOff(double limit) {
  std::vector<Detections>& frames = measurements_.frames();
  std::deque<PositionFix>& fixes = measurements_.fixes();
  std::ranges::stable_sort(frames, {}, &Detections::exposure);
  auto frame = frames.begin();
  while (true) {
    const double fix_t = fixes.empty() ? kNever : fixes.front().t;
    const double frame_t = frame == frames.end() ? kNever : frame->exposure.value();
    const double seen_t = aiding_->NextTime().value_or(kNever);
    const double keyframe_t = chain_.NextKeyframe();
    if (std::min({fix_t, frame_t, seen_t, keyframe_t}) > limit) {
      break;
    }
    if (fix_t <= std::min({frame_t, seen_t, keyframe_t})) {
      TakeFix(fixes.front());
      fixes.pop_front();
    } else if (seen_t <= std::min(frame_t, keyframe_t)) {
      TakeObservation(seen_t);
    } else if (frame_t <= keyframe_t) {
      TakeFrame(*frame);
      ++frame;
    } else {
      NodeAt(keyframe_t);
    }
  }
  frames.erase(frames.begin(), frame);
}

int Navigator::NodeAt(double t) {
  const int before = chain_.size(), node = chain_.NodeAt(t);
  if (chain_.size() > before) {
    UseCompass(t, node);  // takes effect with the next pose
    tracker_.Refresh();
  }
  return node;
}

void Navigator::TakeFix(const PositionFix& fix) {
  const PoseChain::FixUse use = chain_.AddFix(fix);
  if (use == PoseChain::FixUse::kLate) return;
  UseCompass(fix.t, chain_.size() - 1);
  tracker_.Refresh();
  if (use == PoseChain::FixUse::kTaken) {
    tracker_.RefreshAll();
    former_.Update();     // what no match explained in the dive may be clear now:
    ++landmark_version_;  // after it a fix moves all landmarks
  }
}

void Navigator::TakeObservation(double t) {
  if (chain_.IsTooLate(t)) {
    aiding_->Drop();
    return;
  }
  auto offer = aiding_->Take();
  if (!offer) return;
  if (aiding_->Use(*std::move(offer), NodeAt(t))) {
    measurements_.track().NoteFix(t);
    ++landmark_version_;
  }
  tracker_.Refresh();
}

void Navigator::TakeFrame(const Detections& frame) {
  const double t = frame.exposure.value();
  if (chain_.IsTooLate(t)) {
    ++measurements_.counts().late_frames;
    return;
  }
  const bool has_usable =
      std::ranges::any_of(frame.boxes, [this](const Box& box) { return tracker_.IsUsable(box); });
  Viewpoint from{.x = NavVector::Zero(),
                 .node = has_usable ? std::optional(NodeAt(t)) : std::nullopt,
                 .path = measurements_.track().PathAt(t),
                 .altitude = measurements_.AltitudeAt(t),
                 .motion = MotionAt(t)};
  if (from.altitude) {
    box_motion_.Add(frame, measurements_.track().At(t).X_DB, Meters(*from.altitude),
                    params_.objects.min_confidence);
  }
  from.x = has_usable ? smoother_.PoseAt(*from.node) : chain_.Predict(t);
  const std::vector<std::optional<int>> landmarks = tracker_.Process(frame, from);
  bool has_changed = has_usable;
  if (has_usable) {
    smoother_.Update();
    tracker_.Refresh();
    needs_review_ = true;
  }
  const bool is_due = !last_review_t_ || t - *last_review_t_ > kReviewPeriod;
  if (needs_review_ && is_due) {
    ReviewObjects(t);
    has_changed = true;
  }
  const NavVector x = has_changed ? chain_.Predict(t) : from.x;
  posed_.push_back({.frame = frame.frame,
                    .exposure = frame.exposure,
                    .X_WB = PoseOf(x),
                    .altitude = from.altitude,
                    .boxes = frame.boxes});
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    posed_.back().boxes[i].landmark = landmarks[i];
  }
}

std::vector<Disagreement> Navigator::Disagreements() const {
  std::vector<Disagreement> found = measurements_.agreement().Found();
  if (const auto ratio = box_motion_.Disagreement()) {
    found.push_back(
        {SensorAgreement::kSee,
         fmt::format("boxes go {:.2g} times as far through the images as what they show should, "
                     "and {:.2g} times across: the camera hangs otherwise than the vehicle's file "
                     "says, or its focal length is another",
                     ratio->median_H.x(), ratio->median_H.y())});
  }
  return found;
}

BodyMotion Navigator::MotionAt(double t) const {
  const TrackPose pose = measurements_.track().At(t);
  return {.v_B = pose.v_B, .omega_B = {0.0, 0.0, pose.yaw_rate}};
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
  former_.Update();
}

void Navigator::ConvergeAndRefresh(SolveReport& report) {
  report = smoother_.Converge();
  tracker_.RefreshAll();
}

SolveReport Navigator::Finish() {
  SolveReport report;
  if (!has_started()) {
    return report;
  }
  WorkOff(measurements_.track().last_time());
  ConvergeAndRefresh(report);
  // What one round takes out or joins may show the next what else is one, or does not fit.
  for (int round = 0; round < kLastRounds; ++round) {
    const bool has_reviewed = tracker_.Review();
    if (has_reviewed) {
      smoother_.Update();
      ConvergeAndRefresh(report);
    }
    if (!tracker_.Conclude()) {
      if (!has_reviewed) break;
      continue;
    }
    smoother_.Update();
    ConvergeAndRefresh(report);
  }
  tracker_.RefreshAll();
  if (former_.has_former()) {
    former_.Update();
    ConvergeAndRefresh(report);
  }
  ++landmark_version_;
  return report;
}

std::optional<WaterState> Navigator::Water(double t) const {
  const OdometryTrack& track = measurements_.track();
  if (!track.water().has_velocity()) return std::nullopt;
  WaterState water = track.water().StateAt(t, track.ConductAt(t));
  const double off = chain_.Head()(kNavYaw) - track.AttitudeAt(chain_.head_time()).yaw;
  water.current_W = Eigen::Rotation2Dd(off) * water.current_W;  // from the attitude's north
  return water;
}

std::vector<ObservedFrame> Navigator::TakeFrames() { return std::exchange(posed_, {}); }

std::vector<const TrackedObject*> Navigator::LandmarksById() const {
  std::vector<const TrackedObject*> objects;
  for (const TrackedObject& object : tracker_.objects()) {
    if (object.is_landmark()) objects.push_back(&object);
  }
  std::ranges::sort(objects, {}, [](const TrackedObject* object) { return object->id(); });
  return objects;
}

std::vector<Landmark> Navigator::Landmarks() const {
  std::vector<Landmark> landmarks;
  const std::vector<const TrackedObject*> objects = LandmarksById();
  const std::vector<Eigen::Matrix3d> covariances = smoother_.BorderCovariances(SlotsOf(objects));
  for (const TrackedObject* object : objects) {
    const BoxesTogether boxes = tracker_.BoxesOf(*object);
    landmarks.push_back(
        {.id = object->id(),
         .object = {.p_W = smoother_.BorderAt(object->slot()),
                    .cov_W = covariances[landmarks.size()] + object->MotionCovariance(),
                    .color = boxes.color,
                    .size = tracker_.SizeOf(*object)},
         .detections = boxes.count,
         .former = object->former});
  }
  return landmarks;
}

Eigen::MatrixXd Navigator::LandmarkCovariance() const {
  const std::vector<int> slots = SlotsOf(LandmarksById());
  const auto n = static_cast<Eigen::Index>(3 * slots.size());
  return slots.empty() ? Eigen::MatrixXd()
                       : Eigen::MatrixXd(smoother_.Covariance(slots).bottomRightCorner(n, n));
}

std::vector<SmoothedPose> Navigator::Smoothed(int first) const {
  std::vector<SmoothedPose> poses;
  for (int i = first; i < node_count(); ++i)
    poses.push_back({chain_.TimeOf(i), PoseOf(smoother_.PoseAt(i))});
  return poses;
}

std::vector<Eigen::Vector4d> Navigator::SmoothedSigmas() const {
  std::vector<Eigen::Vector4d> sigmas;
  if (!has_started()) return sigmas;
  for (const NavCovariance& covariance : smoother_.PoseCovariances())
    sigmas.emplace_back(covariance.diagonal().head<4>().cwiseMax(0.0).cwiseSqrt());
  return sigmas;
}

}  // namespace limpet
