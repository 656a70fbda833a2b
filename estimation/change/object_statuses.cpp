// SPDX-License-Identifier: MIT
#include "estimation/change/object_statuses.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/change/distance_over_ground.hpp"
#include "estimation/change/moved_pairs.hpp"
#include "estimation/change/watched_place.hpp"

namespace limpet {
namespace {

/// The mission's rate of false boxes is worth as much as so many frames.
constexpr double kBelievedFrames = 100.0;

/// What a tentative object is believed to be before anyone has looked, and how near another entry
/// tells about it.
constexpr double kTentativeIsObject = 0.3;
constexpr double kTentativeReach = 1.5;

/// What all images together say: sun, tilt and ground are not so well known as to be sure.
constexpr double kMostOfContrast = 6.0;

/// Lambda of a former session that would have seen what it did not.
constexpr double kNothingThere = -30.0;

/// Often detected, and believed to be none.
int CountDoubted(const std::vector<Landmark>& landmarks, const std::vector<OpiBelief>& objects) {
  constexpr int kLeastDetections = 10;  // detections of one object
  constexpr double kLikely = 0.5;
  return static_cast<int>(std::ranges::count_if(landmarks, [&](const Landmark& landmark) {
    const bool is_believed = std::ranges::any_of(objects, [&](const OpiBelief& object) {
      return object.landmark == landmark.id && object.posterior.present() >= kLikely;
    });
    return landmark.detections >= kLeastDetections && !is_believed;
  }));
}

}  // namespace

ObjectStatuses::ObjectStatuses(const StatusParams& params, const CameraModel& camera)
    : params_(params),
      landmarks_(params.merge_within),
      watches_({.look = params.LookFrom(camera), .visibilities = VisibilityBelief::Grid()},
               params.looks),
      water_(params.detection.visibility, params.visibility_spread),
      former_water_(FormerViews{}.water) {}

void ObjectStatuses::SetFormer(std::vector<FormerObject> former) {
  // Former objects take the first ids, so that they keep them when they are found again.
  ids_.Reserve(static_cast<int>(former.size()));
  ties_.emplace(std::move(former), params_.matching);
  ties_->Take(landmarks_.objects());
  watches_.WatchFormer(*ties_, landmarks_);
}

void ObjectStatuses::AddFrame(ObservedFrame frame) {
  landmarks_.NoteSeenTogether(frame);
  tentative_.AddFrame(frame, watches_.model(), [this](const ObservedFrame& in, const Box& box) {
    return Representative(box.landmark) || watches_.IsExplained(in, box, landmarks_);
  });
  watches_.Add(std::move(frame), landmarks_);
}

void ObjectStatuses::SetLandmarks(const std::vector<Landmark>& landmarks) {
  Watch(landmarks_.Set(landmarks));
}

void ObjectStatuses::Rejudge() {
  watches_.JudgeAnew(FalseRate());
  former_sight_.Forget();
  Watch(false);
}

void ObjectStatuses::Watch(bool are_owners_new) {
  if (ties_) ties_->Take(landmarks_.objects());
  watches_.Watch(landmarks_, ties_ ? &*ties_ : nullptr, are_owners_new);
}

double ObjectStatuses::FalseRate() const {
  double boxes = kBelievedFrames * params_.detection.false_per_image;
  for (const ObservedFrame& frame : frames()) {
    boxes += static_cast<double>(std::ranges::count_if(frame.boxes, [&](const Box& box) {
      return !Representative(box.landmark) && !watches_.IsExplained(frame, box, landmarks_);
    }));
  }
  return boxes / (kBelievedFrames + static_cast<double>(frames().size()));
}

const Box* ObjectStatuses::BoxOf(const OpiBelief& object, const ObservedFrame& frame) const {
  if (!object.landmark) return nullptr;
  return FindBox(frame, WatchedPlace(object.object), watches_.model(),
                 PlaceWatches::OwnerFor(*object.landmark, landmarks_));
}

VisibilityBelief ObjectStatuses::Water() const {
  VisibilityBelief water(params_.detection.visibility, params_.visibility_spread);
  water.Add(contrasts_.LogLikelihood(), kMostOfContrast);
  watches_.Teach(water);
  return water;
}

double ObjectStatuses::FormerLambdaAt(const Landmark& newcomer) {
  const PlaceWatch& watch = former_sight_.At(newcomer, *ties_);
  return LambdaIn(former_water_, watch.evidence().Lambda(params_.priors.lookalike), params_.priors);
}

StatusPosterior ObjectStatuses::PosteriorOfFormer(std::size_t former) const {
  const double lambda = ties_->former()[former].log_likelihood_ratio;
  const double sum_of_chances = ties_->SumOfFormer(former);
  StatusPosterior sum{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  const auto add = [&](double former_lambda, const PlaceWatch& watch, double share) {
    sum.Add(ChangeStatus(former_lambda, watch.evidence(), water_, params_.priors), share);
  };
  for (std::size_t j = 0; j < landmarks_.objects().size(); ++j) {
    const double share = ties_->Chance(former, j) / std::max(sum_of_chances, 1.0);
    if (share > 0.0) add(lambda, WatchOf(j), share);
  }
  const double rest = 1.0 - std::min(sum_of_chances, 1.0);
  const std::optional<std::size_t> stands_in = ties_->NowOf(former);
  if (rest > 0.0 && stands_in) {
    // Moved to where the landmark is, or gone and another one came: that one is there in any case.
    add(kNothingThere, WatchOf(*stands_in), rest);
  } else if (const PlaceWatch* watch = watches_.OfFormer(former)) {
    add(lambda, *watch, rest);
  }
  return sum;
}

StatusPosterior ObjectStatuses::PosteriorOfNewcomer(std::size_t object) {
  const PlaceEvidence now = WatchOf(object).evidence();
  const auto change_from = [&](double former_lambda) {
    return ChangeStatus(former_lambda, now, water_, params_.priors);
  };
  const StatusPosterior unknown_before = change_from(FormerLambdaAt(landmarks_.objects()[object]));
  const double known = ties_->SumOfObject(object);
  if (known <= 0.0) return unknown_before;
  StatusPosterior sum{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  for (std::size_t i = 0; i < ties_->former().size(); ++i) {
    sum.Add(change_from(ties_->former()[i].log_likelihood_ratio),
            ties_->Chance(i, object) / std::max(known, 1.0));
  }
  sum.Add(unknown_before, 1.0 - std::min(known, 1.0));
  return sum;
}

OpiBelief ObjectStatuses::BeliefFrom(const PlaceWatch& watch) const {
  OpiBelief belief;
  belief.log_likelihood_ratio =
      LambdaIn(water_, watch.evidence().Lambda(params_.priors.lookalike), params_.priors);
  belief.looks = static_cast<int>(std::lround(water_.Expect(watch.looks())));
  belief.looks_with_box = watch.looks_with_box();
  return belief;
}

OpiBelief ObjectStatuses::StatusOfFormer(std::size_t former) const {
  const std::optional<std::size_t> now = ties_->NowOf(former);
  OpiBelief status = BeliefFrom(now ? WatchOf(*now) : *watches_.OfFormer(former));
  status.id = static_cast<int>(former) + 1;
  status.former_id = ties_->former()[former].id;
  if (now) status.landmark = landmarks_.objects()[*now].id;
  status.object = now ? landmarks_.objects()[*now].object : ties_->PlaceNow(former);
  status.posterior = PosteriorOfFormer(former);
  status.decided = Decide(status.posterior, status.looks, params_.priors);
  if (status.decided == Status::kConfirmed && !now) {
    status.decided = Status::kUncertain;  // boxes near by, but the smoother knows no object
  }
  return status;
}

std::optional<OpiBelief> ObjectStatuses::StatusOfNewcomer(std::size_t object) {
  const Landmark& landmark = landmarks_.objects()[object];
  OpiBelief status = BeliefFrom(WatchOf(object));
  status.landmark = landmark.id;
  status.object = landmark.object;
  status.posterior = ties_ ? PosteriorOfNewcomer(object)
                           : DiscoveryStatus(WatchOf(object).evidence(), water_, params_.priors);
  status.decided = Decide(status.posterior, status.looks, params_.priors);
  if (status.decided == Status::kNothing) return std::nullopt;
  if (ties_ && ties_->SumOfObject(object) > 0.0) {
    status.decided = Status::kUncertain;  // which former object it is, if any, is undecided
  }
  status.id = ids_.OfLandmark(landmark.id, landmarks_.representatives());
  return status;
}

bool ObjectStatuses::IsToldOf(const ObjectEstimate& place) const {
  const auto is_near = [&](const ObjectEstimate& other) {
    return DistanceOverGround(other, place) < kTentativeReach;
  };
  if (std::ranges::any_of(landmarks_.objects(), is_near, &Landmark::object)) return true;
  for (std::size_t i = 0; ties_ && i < ties_->former().size(); ++i) {
    if (!ties_->NowOf(i) && is_near(ties_->PlaceNow(i))) return true;
  }
  return false;
}

std::optional<OpiBelief> ObjectStatuses::StatusOfTentative(TentativeObject& tentative) {
  if (IsToldOf(tentative.place)) return std::nullopt;
  if (tentative.id == 0) tentative.id = ids_.Take();
  return OpiBelief{
      .id = tentative.id,
      .object = tentative.place,
      .looks = tentative.good_looks,
      .posterior = {.appeared = kTentativeIsObject, .nothing = 1.0 - kTentativeIsObject}};
}

std::vector<OpiBelief> ObjectStatuses::Assess() {
  water_ = Water();
  if (ties_) former_water_ = former_sight_.Water(landmarks_.objects(), *ties_, params_.priors);
  std::vector<OpiBelief> objects;
  for (std::size_t i = 0; ties_ && i < ties_->former().size(); ++i) {
    objects.push_back(StatusOfFormer(i));
  }
  for (std::size_t i = 0; i < landmarks_.objects().size(); ++i) {
    if (ties_ && ties_->StandsForFormer(i)) continue;
    if (std::optional<OpiBelief> status = StatusOfNewcomer(i)) {
      objects.push_back(std::move(*status));
    }
  }
  PairMoved(objects, params_.matching.moved_within.value());
  landmarks_doubted_ = CountDoubted(landmarks_.objects(), objects);
  for (TentativeObject* tentative : tentative_.Open()) {
    if (std::optional<OpiBelief> status = StatusOfTentative(*tentative)) {
      objects.push_back(std::move(*status));
    }
  }
  return objects;
}

}  // namespace limpet
