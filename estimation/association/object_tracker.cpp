// SPDX-License-Identifier: MIT
#include "estimation/association/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/association/track_placement.hpp"
#include "estimation/association/visibility.hpp"
#include "estimation/smoothing/camera_point.hpp"

namespace limpet {
namespace {

constexpr int kRefreshesPerFar = 4;   // one that is far costs a way down the tree
constexpr double kSoonInReach = 6.0;  // [m] beyond what may be seen now: about a leaf's way

Observation ObservationOf(const Candidate& candidate, const Detections& frame,
                          const Viewpoint& from) {
  return {.frame = frame.frame,
          .detection = candidate.detection,
          .node = *from.node,
          .t = frame.exposure.value(),
          .reading = candidate.seen.reading,
          .color = candidate.seen.box.color,
          .confidence = candidate.seen.box.confidence,
          .motion = from.motion,
          .altitude = from.altitude,
          .terms = {}};
}

}  // namespace

ObjectTracker::ObjectTracker(Smoother& smoother, const CameraModel& camera,
                             const ObjectTrackerParams& params)
    : smoother_(smoother),
      params_(params),
      mount_(camera, params.mount, smoother),
      terms_(smoother, mount_, params_, tracks_),
      associator_(smoother, mount_, params_, tracks_),
      confirmation_(smoother, params_, tracks_, terms_),
      review_(smoother, mount_, params_, tracks_, terms_),
      identities_(smoother, params_, tracks_, terms_) {}

bool ObjectTracker::IsUsable(const Box& box) const {
  return box.confidence >= params_.min_confidence && box.w > 1.0 && box.h > 1.0;
}

std::vector<Candidate> ObjectTracker::CandidatesOf(const Detections& frame) const {
  std::vector<Candidate> candidates;
  for (int i = 0; i < static_cast<int>(frame.boxes.size()); ++i) {
    const Box& box = frame.boxes[static_cast<std::size_t>(i)];
    if (!IsUsable(box)) continue;
    candidates.push_back(
        {.detection = i, .seen = {box, ReadBox(box, mount_.camera(), params_.model.noise)}});
  }
  return candidates;
}

std::vector<std::optional<int>> ObjectTracker::Process(const Detections& frame,
                                                       const Viewpoint& from) {
  std::vector<std::optional<int>> shown(frame.boxes.size());
  const std::vector<Candidate> candidates =
      from.node ? CandidatesOf(frame) : std::vector<Candidate>();
  tracks_.now = frame.exposure.value();
  DropStale();
  const std::size_t known = tracks_.objects.size();
  const std::vector<Association> associations = associator_.Assign(from, candidates);
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (associations[i].kind == Association::Kind::kAmbiguous) continue;
    Observation observation = ObservationOf(candidates[i], frame, from);
    if (associations[i].kind == Association::Kind::kTrack) {
      seen.push_back(associations[i].track);
      TrackedObject& track = tracks_.objects[associations[i].track];
      AddObservation(track, std::move(observation), from);
      shown[static_cast<std::size_t>(candidates[i].detection)] = tracks_.LandmarkIdOf(track);
    } else if (observation.reading.TellsPlace(params_.model.radius_m)) {
      StartTrack(std::move(observation), from);
    } else {
      unplaced_.NoteUnusable(candidates[i].seen.box, from.x.head<3>(), tracks_.now);
    }
  }
  for (std::size_t j = known; j < tracks_.objects.size(); ++j)
    seen.push_back(j);
  CountVisibility(from, seen, mount_, params_, tracks_);
  confirmation_.ConfirmWhatIsDue(from.x);
  return shown;
}

void ObjectTracker::AddObservation(TrackedObject& object, Observation observation,
                                   const Viewpoint& from) {
  const bool is_new_pass = observation.t - object.last_seen() > params_.confirm_within_s;
  object.sightings.last_path = from.path;
  object.sightings.max_distance =
      std::max(object.sightings.max_distance,
               CameraPointOf(mount_.At(from.motion), from.x, object.p_W).p_C.norm());
  object.review.is_due = true;
  object.observations.Add(std::move(observation));
  if (object.is_mapped()) {
    terms_.AddTerms(object, object.observations.back(), is_new_pass);
    tracks_.identity_news += is_new_pass ? 1 : 0;
  } else {
    Place(object, smoother_, mount_, params_.model);
  }
}

void ObjectTracker::StartTrack(Observation observation, const Viewpoint& from) {
  TrackedObject object;
  object.sightings.last_path = from.path;
  object.observations.Add(std::move(observation));
  Place(object, smoother_, mount_, params_.model);
  object.sightings.max_distance =
      CameraPointOf(mount_.At(from.motion), from.x, object.p_W).p_C.norm();
  tracks_.objects.push_back(std::move(object));
}

void ObjectTracker::DropStale() {
  std::erase_if(tracks_.objects, [this](const TrackedObject& object) {
    const bool is_stale =
        !object.is_mapped() && tracks_.now - object.last_seen() > params_.confirm_within_s;
    if (is_stale) unplaced_.NoteDropped(object);
    return is_stale;
  });
}

std::optional<ObjectSize> ObjectTracker::SizeOf(const TrackedObject& landmark) const {
  if (!landmark.size()) return std::nullopt;
  const ObjectSizes& sizes = terms_.sizes();
  const double radius = params_.model.radius_m * std::exp(sizes.LogSizeAt(*landmark.size()));
  return ObjectSize{.radius = radius, .sd = radius * std::sqrt(sizes.VarianceOf(*landmark.size()))};
}

bool ObjectTracker::Review() {
  bool has_changed = review_.RemoveOutliers();
  has_changed = review_.DoubtDuplicates() || has_changed;
  has_changed = identities_.DecideWhatIsDue() || has_changed;
  has_changed = terms_.RemoveAbsorbed(false) || has_changed;
  LearnSizes();
  return review_.DropFalseLandmarks() || has_changed;
}

void ObjectTracker::LearnSizes() {
  std::vector<SizeSlot> seen;
  for (const TrackedObject& object : tracks_.objects) {
    if (object.is_landmark() && object.size()) seen.push_back(*object.size());
  }
  terms_.sizes().Learn(seen);
}

void ObjectTracker::Refresh(TrackedObject& object) {
  object.p_W = smoother_.BorderAt(object.slot());
  if (object.size()) object.log_size = terms_.sizes().LogSizeAt(*object.size());
}

void ObjectTracker::RefreshAll() {
  for (TrackedObject& object : tracks_.objects) {
    if (object.is_mapped()) Refresh(object);
  }
}

void ObjectTracker::Refresh() {
  for (std::size_t i = 0; i < tracks_.objects.size(); ++i) {
    TrackedObject& object = tracks_.objects[i];
    const bool is_due = i == next_far_ && refreshes_ == 0;
    if (object.is_mapped() && (is_due || smoother_.IsAtHand(object.slot()))) Refresh(object);
  }
  if (refreshes_ == 0) next_far_ = next_far_ < tracks_.objects.size() ? next_far_ + 1 : 0;
  refreshes_ = (refreshes_ + 1) % kRefreshesPerFar;
  KeepNearAtHand();
}

void ObjectTracker::KeepNearAtHand() {
  const int nodes = smoother_.graph().node_count();
  if (nodes == 0) return;
  const Eigen::Vector3d p_W = smoother_.PoseAt(nodes - 1).head<3>();
  const double reach = associator_.Reach() + kSoonInReach;
  std::vector<int> near;
  for (const TrackedObject& object : tracks_.objects) {
    const bool is_near =
        object.is_mapped() &&
        (object.is_open() || (object.p_W - p_W).norm() < object.sightings.max_distance + reach);
    if (!is_near) continue;
    near.push_back(object.slot());
    if (object.size()) near.push_back(object.size()->slot);
  }
  smoother_.KeepAtHand(near);
}

}  // namespace limpet
