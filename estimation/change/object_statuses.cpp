// SPDX-License-Identifier: MIT
#include "estimation/change/object_statuses.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/change/watched_place.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// The mission's rate of false boxes is worth as much as so many frames.
constexpr double kBelievedFrames = 100.0;

/// What a tentative object is believed to be before anyone has looked, and how near another entry
/// tells about it.
constexpr double kTentativeIsObject = 0.3;
constexpr double kTentativeReach = 1.5;

double HorizontalDistance(const ObjectEstimate& a, const ObjectEstimate& b) {
  return (a.p_W - b.p_W).head<2>().norm();
}

}  // namespace

ObjectStatuses::ObjectStatuses(const StatusParams& params, const CameraModel& camera)
    : params_(params),
      model_{.look = params.LookFrom(camera), .visibilities = VisibilityBelief::Grid()},
      water_(params.detection.visibility, params.visibility_spread),
      former_water_(former_views_.water) {}

void ObjectStatuses::AddFrame(ObservedFrame frame) {
  LIMPET_REQUIRE(frames_.empty() || frame.exposure >= frames_.back().exposure,
                 "frames out of order");
  for (std::size_t i = 0; i < frame.boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < frame.boxes.size(); ++j) {
      const std::optional<int>&a = frame.boxes[i].landmark, &b = frame.boxes[j].landmark;
      if (a && b) seen_together_.insert(std::minmax(*a, *b));
    }
  }
  for (auto& [landmark, watch] : landmark_watch_) {
    watch.See(frame, model_, OwnerForLandmark(landmark));
  }
  for (std::optional<PlaceWatch>& watch : former_watch_) {
    if (watch) watch->See(frame, model_, OwnerForFormer());
  }
  tentative_.AddFrame(frame, model_, [this](const ObservedFrame& in, const Box& box) {
    return Representative(box.landmark) || IsExplained(in, box);
  });
  frames_.push_back(std::move(frame));
}

void ObjectStatuses::MoveFrames(const std::function<Pose(double t, const Pose& X_WB)>& moved) {
  for (ObservedFrame& frame : frames_) {
    frame.X_WB = moved(frame.exposure.value(), frame.X_WB);
  }
  rejudges_all_ = true;
}

void ObjectStatuses::SetLandmarks(const std::vector<Landmark>& landmarks) {
  landmarks_ = landmarks;
  std::ranges::sort(landmarks_, {}, &Landmark::id);
  const std::map<int, int> before = representative_;
  MergeLandmarks();
  if (rejudges_all_) {
    landmark_watch_.clear();
  }
  WatchLandmarks();
  if (former_) {
    TakeMatches();
    // Who owns a box depends on which landmarks there are.
    WatchFormer(rejudges_all_ || before != representative_);
  }
  rejudges_all_ = false;
}

double ObjectStatuses::FalseRate() const {
  double boxes = kBelievedFrames * params_.detection.false_per_image;
  for (const ObservedFrame& frame : frames_) {
    boxes += static_cast<double>(std::ranges::count_if(frame.boxes, [&](const Box& box) {
      return !Representative(box.landmark) && !IsExplained(frame, box);
    }));
  }
  return boxes / (kBelievedFrames + static_cast<double>(frames_.size()));
}

void ObjectStatuses::Rejudge() {
  model_.look.detection.false_per_image = FalseRate();
  landmark_watch_.clear();
  newcomer_watch_.clear();
  WatchLandmarks();
  if (former_) {
    TakeMatches();
    WatchFormer(true);
  }
  rejudges_all_ = false;
}

std::optional<int> ObjectStatuses::Representative(const std::optional<int>& landmark) const {
  if (!landmark) return std::nullopt;
  const auto found = representative_.find(*landmark);
  return found == representative_.end() ? std::nullopt : std::optional(found->second);
}

const Box* ObjectStatuses::BoxOf(const OpiBelief& object, const ObservedFrame& frame) const {
  if (!object.landmark) return nullptr;
  return FindBox(frame, WatchedPlace(object.object), model_, OwnerForLandmark(*object.landmark));
}

void ObjectStatuses::Replay(PlaceWatch& watch, const OwnerOf& owner_of) const {
  for (const ObservedFrame& frame : frames_) {
    watch.See(frame, model_, owner_of);
  }
}

OwnerOf ObjectStatuses::OwnerForLandmark(int landmark) const {
  return [this, landmark](const ObservedFrame&, const Box& box) {
    const std::optional<int> owner = Representative(box.landmark);
    if (!owner) return BoxOwner::kUnknown;
    return owner == landmark ? BoxOwner::kThisPlace : BoxOwner::kAnotherPlace;
  };
}

bool ObjectStatuses::IsExplained(const ObservedFrame& frame, const Box& box) const {
  return std::ranges::any_of(objects_, [&](const Landmark& object) {
    const std::optional<Foresight> foresight =
        Foresee(WatchedPlace(object.object), frame.X_WB, model_);
    return foresight && foresight->Explains(box, model_.look.camera);
  });
}

bool ObjectStatuses::AreOne(const Landmark& a, const Landmark& b) const {
  const bool are_two_former =
      a.former.is_decided() && b.former.is_decided() && a.former.id != b.former.id;
  return !are_two_former && HorizontalDistance(a.object, b.object) < params_.merge_within.value() &&
         !seen_together_.contains(std::minmax(a.id, b.id));
}

void ObjectStatuses::MergeLandmarks() {
  std::vector<const Landmark*> by_detections;
  for (const Landmark& landmark : landmarks_) {
    by_detections.push_back(&landmark);
  }
  std::ranges::stable_sort(
      by_detections, [](const auto* a, const auto* b) { return a->detections > b->detections; });
  objects_.clear();
  representative_.clear();
  for (const Landmark* landmark : by_detections) {
    const auto same = std::ranges::find_if(
        objects_, [&](const Landmark& object) { return AreOne(object, *landmark); });
    representative_[landmark->id] = same == objects_.end() ? landmark->id : same->id;
    if (same == objects_.end()) {
      objects_.push_back(*landmark);
    } else if (landmark->former.is_decided() || !same->former.is_possible()) {
      same->former = landmark->former;
    }
  }
  std::ranges::sort(objects_, {}, &Landmark::id);
}

void ObjectStatuses::WatchLandmarks() {
  std::erase_if(landmark_watch_,
                [this](const auto& entry) { return Representative(entry.first) != entry.first; });
  for (const Landmark& object : objects_) {
    const auto found = landmark_watch_.find(object.id);
    const ObjectEstimate place = WatchedPlace(object.object);
    if (found != landmark_watch_.end() && !HasMoved(found->second, place)) {
      continue;
    }
    PlaceWatch watch(place, params_.looks);
    Replay(watch, OwnerForLandmark(object.id));
    landmark_watch_.insert_or_assign(object.id, std::move(watch));
  }
}

int ObjectStatuses::IdOfLandmark(int landmark) {
  const auto known = id_of_landmark_.find(landmark);
  if (known != id_of_landmark_.end()) {
    return known->second;
  }
  // A landmark that now stands for another one goes on under that one's id.
  for (const auto& [other, representative] : representative_) {
    const auto inherited = id_of_landmark_.find(other);
    if (representative == landmark && inherited != id_of_landmark_.end()) {
      return inherited->second;
    }
  }
  id_of_landmark_[landmark] = next_id_;
  return next_id_++;
}

OpiBelief ObjectStatuses::StatusOfFormer(std::size_t index) const {
  const FormerObject& former = (*former_)[index];
  const std::optional<int> now = match_.now_of_former[index];
  const Landmark* object = now ? &objects_[static_cast<std::size_t>(*now)] : nullptr;
  const PlaceWatch& watch =
      object != nullptr ? landmark_watch_.at(object->id) : *former_watch_[index];
  OpiBelief status{.id = static_cast<int>(index) + 1,
                   .landmark = object != nullptr ? std::optional(object->id) : std::nullopt,
                   .former_id = former.id,
                   .object = object != nullptr ? object->object : FormerPlace(index),
                   .log_likelihood_ratio = LambdaOf(watch),
                   .looks = Looks(watch),
                   .looks_with_box = watch.looks_with_box(),
                   .posterior = PosteriorOfFormer(index)};
  status.decided = Decide(status.posterior, status.looks, params_.priors);
  if (status.decided == Status::kConfirmed && object == nullptr) {
    status.decided = Status::kUncertain;  // boxes near by, but the smoother knows no object
  }
  return status;
}

std::optional<OpiBelief> ObjectStatuses::StatusOfNewcomer(std::size_t index) {
  const Landmark& object = objects_[index];
  const PlaceWatch& watch = landmark_watch_.at(object.id);
  OpiBelief status{.landmark = object.id,
                   .object = object.object,
                   .log_likelihood_ratio = LambdaOf(watch),
                   .looks = Looks(watch),
                   .looks_with_box = watch.looks_with_box(),
                   .posterior = former_
                                    ? PosteriorOfNewcomer(index)
                                    : DiscoveryStatus(watch.evidence(), water_, params_.priors)};
  status.decided = Decide(status.posterior, status.looks, params_.priors);
  const bool may_be_former =
      former_ && match_.chance.col(static_cast<Eigen::Index>(index)).sum() > 0.0;
  if (status.decided != Status::kNothing && may_be_former) {
    status.decided = Status::kUncertain;  // which former object it is, if any, is undecided
  }
  if (status.decided == Status::kNothing) {
    return std::nullopt;
  }
  status.id = IdOfLandmark(object.id);
  return status;
}

std::optional<OpiBelief> ObjectStatuses::StatusOfTentative(TentativeObject& tentative) {
  const bool is_told = std::ranges::any_of(objects_, [&](const Landmark& object) {
    return HorizontalDistance(object.object, tentative.place) < kTentativeReach;
  });
  if (is_told) {
    return std::nullopt;
  }
  for (std::size_t i = 0; former_ && i < former_->size(); ++i) {
    if (!match_.now_of_former[i] &&
        HorizontalDistance(FormerPlace(i), tentative.place) < kTentativeReach) {
      return std::nullopt;
    }
  }
  tentative.id = tentative.id > 0 ? tentative.id : next_id_++;
  return OpiBelief{
      .id = tentative.id,
      .object = tentative.place,
      .looks = tentative.good_looks,
      .posterior = {.appeared = kTentativeIsObject, .nothing = 1.0 - kTentativeIsObject}};
}

std::vector<OpiBelief> ObjectStatuses::Assess() {
  water_ = Water();
  if (former_) former_water_ = FormerWater();
  std::vector<OpiBelief> objects;
  std::vector<bool> is_matched(objects_.size(), false);
  for (std::size_t i = 0; former_ && i < former_->size(); ++i) {
    objects.push_back(StatusOfFormer(i));
    if (const std::optional<int> now = match_.now_of_former[i]) {
      is_matched[static_cast<std::size_t>(*now)] = true;
    }
  }
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (is_matched[i]) continue;
    if (std::optional<OpiBelief> status = StatusOfNewcomer(i)) {
      objects.push_back(std::move(*status));
    }
  }
  PairMoved(objects);
  landmarks_doubted_ = CountDoubted(objects);
  for (TentativeObject* tentative : tentative_.Open()) {
    if (std::optional<OpiBelief> status = StatusOfTentative(*tentative)) {
      objects.push_back(std::move(*status));
    }
  }
  return objects;
}

}  // namespace limpet
