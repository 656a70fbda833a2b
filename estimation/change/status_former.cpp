// SPDX-License-Identifier: MIT
// What a ObjectStatuses makes of the former session: its objects, its frame, and what it would have
// seen.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "estimation/change/object_statuses.hpp"
#include "estimation/change/watched_place.hpp"
#include "estimation/matching/own_covariance.hpp"

namespace limpet {
namespace {

/// Lambda of a former session that would have seen what it did not.
constexpr double kNothingThere = -30.0;

}  // namespace

void ObjectStatuses::SetFormer(std::vector<FormerObject> former) {
  former_watch_.assign(former.size(), std::nullopt);
  former_ = std::move(former);
  // Former objects take the first ids, so that they keep them when they are found again.
  next_id_ = std::max(next_id_, static_cast<int>(former_->size()) + 1);
  TakeMatches();
  WatchFormer(true);
}

void ObjectStatuses::SetFormerViews(FormerViews views) {
  former_views_ = std::move(views);
  former_views_.model.visibilities = VisibilityBelief::Grid();
  newcomer_watch_.clear();
}

OwnerOf ObjectStatuses::OwnerForFormer() const {
  // A former place is watched by itself only while no landmark stands for it, so every confirmed
  // landmark is another object; also in frames from before it was confirmed.
  return [this](const ObservedFrame& frame, const Box& box) {
    const bool is_another = Representative(box.landmark) || IsExplained(frame, box);
    return is_another ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

void ObjectStatuses::TakeCandidates(const Landmark& landmark, std::size_t object) {
  const auto take = [&](int former_id, double chance, bool is_best) {
    const auto found = std::ranges::find(*former_, former_id, &FormerObject::id);
    if (found == former_->end()) return;  // of another former session
    const auto i = found - former_->begin();
    std::optional<int>& now = match_.now_of_former[static_cast<std::size_t>(i)];
    if (is_best && !now) now = static_cast<int>(object);
    match_.chance(i, static_cast<Eigen::Index>(object)) = std::clamp(chance, 0.0, 1.0);
  };
  for (const FormerCandidate& candidate : landmark.former.candidates)
    take(candidate.id, candidate.probability, candidate.id == landmark.former.id);
  if (landmark.former.is_decided()) take(*landmark.former.id, landmark.former.probability, true);
}

void ObjectStatuses::TakeMatches() {
  std::vector<ObjectEstimate> former = EstimatesOf(*former_);
  std::vector<ObjectEstimate> now;
  for (const Landmark& object : objects_) {
    now.push_back(object.object);
  }
  match_.now_of_former.assign(former.size(), std::nullopt);
  match_.chance.setZero(static_cast<Eigen::Index>(former.size()),
                        static_cast<Eigen::Index>(now.size()));
  for (std::size_t j = 0; j < objects_.size(); ++j)
    TakeCandidates(objects_[j], j);
  // The offset rests on what is decided alone.
  FormerMatches decided = match_.now_of_former;
  for (std::optional<int>& now_of : decided) {
    if (now_of && !objects_[static_cast<std::size_t>(*now_of)].former.is_decided()) now_of.reset();
  }
  const SessionMatch fit =
      FitSessions(WithOwnCovariance(std::move(former)), WithOwnCovariance(std::move(now)),
                  std::move(decided), params_.matching);
  match_.offset = fit.offset;
  match_.offset_cov = fit.offset_cov;
}

double ObjectStatuses::ChanceOfFormer(std::size_t index) const {
  return std::min(match_.chance.row(static_cast<Eigen::Index>(index)).sum(), 1.0);
}

StatusPosterior ObjectStatuses::PosteriorOfFormer(std::size_t index) const {
  const double former = (*former_)[index].log_likelihood_ratio;
  const auto row = match_.chance.row(static_cast<Eigen::Index>(index));
  const double total = std::max(row.sum(), 1.0);  // several landmarks may each be likely it
  StatusPosterior sum{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  const auto add = [&](const PlaceWatch& watch, double share) {
    sum.Add(ChangeStatus(former, watch.evidence(), water_, params_.priors), share);
  };
  for (std::size_t j = 0; j < objects_.size(); ++j) {
    const double chance = row(static_cast<Eigen::Index>(j)) / total;
    if (chance > 0.0) add(landmark_watch_.at(objects_[j].id), chance);
  }
  const double rest = 1.0 - ChanceOfFormer(index);
  const std::optional<int> stands_in = match_.now_of_former[index];
  if (rest > 0.0 && stands_in) {
    // Moved to where the landmark is, or gone and another one came: that one is there in any case.
    const PlaceWatch& watch = landmark_watch_.at(objects_[static_cast<std::size_t>(*stands_in)].id);
    sum.Add(ChangeStatus(kNothingThere, watch.evidence(), water_, params_.priors), rest);
  } else if (former_watch_[index]) {
    add(*former_watch_[index], rest);
  }
  return sum;
}

StatusPosterior ObjectStatuses::PosteriorOfNewcomer(std::size_t index) {
  const Landmark& object = objects_[index];
  const PlaceEvidence now = landmark_watch_.at(object.id).evidence();
  StatusPosterior sum = ChangeStatus(FormerLambdaAt(object), now, water_, params_.priors);
  const auto column = match_.chance.col(static_cast<Eigen::Index>(index));
  const double known = column.sum();
  if (known <= 0.0) {
    return sum;
  }
  sum = StatusPosterior{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
  const double total = std::max(known, 1.0);
  for (std::size_t i = 0; i < former_->size(); ++i) {
    const double former = (*former_)[i].log_likelihood_ratio;
    sum.Add(ChangeStatus(former, now, water_, params_.priors),
            column(static_cast<Eigen::Index>(i)) / total);
  }
  sum.Add(ChangeStatus(FormerLambdaAt(object), now, water_, params_.priors),
          1.0 - std::min(known, 1.0));
  return sum;
}

ObjectEstimate ObjectStatuses::InOtherFrame(ObjectEstimate place,
                                            const Eigen::Vector3d& p_W) const {
  const double own = std::pow(params_.matching.position_floor.value(), 2);
  place.p_W = p_W;
  place.cov_W = own * Eigen::Matrix3d::Identity();
  place.cov_W.topLeftCorner<2, 2>() += match_.offset_cov.topLeftCorner<2, 2>();
  return place;
}

ObjectEstimate ObjectStatuses::FormerPlace(std::size_t index) const {
  const ObjectEstimate& former = (*former_)[index].object;
  return InOtherFrame(former, match_.offset.Apply(former.p_W));
}

void ObjectStatuses::WatchFormer(bool rejudges_all) {
  for (std::size_t i = 0; i < former_->size(); ++i) {
    std::optional<PlaceWatch>& watch = former_watch_[i];
    if (match_.now_of_former[i] && ChanceOfFormer(i) >= 1.0) {
      watch.reset();
      continue;
    }
    const ObjectEstimate place = FormerPlace(i);
    if (rejudges_all || !watch || HasMoved(*watch, place)) {
      watch.emplace(place, params_.looks);
      Replay(*watch, OwnerForFormer());
    }
  }
}

OwnerOf ObjectStatuses::OwnerInFormerViews() const {
  return [this](const ObservedFrame& view, const Box& box) {
    const bool is_listed = std::ranges::any_of(*former_, [&](const FormerObject& former) {
      const std::optional<Foresight> foresight =
          Foresee(WatchedPlace(former.object), view.X_WB, former_views_.model);
      return foresight && foresight->Explains(box, former_views_.model.look.camera);
    });
    return is_listed ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

const PlaceWatch& ObjectStatuses::FormerWatchAt(const Landmark& newcomer) {
  const ObjectEstimate place =
      InOtherFrame(newcomer.object, match_.offset.Undo(newcomer.object.p_W));
  const auto known = newcomer_watch_.find(newcomer.id);
  if (known != newcomer_watch_.end() && !HasMoved(known->second, place)) return known->second;
  PlaceWatch watch(place, former_views_.looks);
  const OwnerOf owner_of = OwnerInFormerViews();
  for (const ObservedFrame& view : former_views_.frames) {
    watch.See(view, former_views_.model, owner_of);
  }
  return newcomer_watch_.insert_or_assign(newcomer.id, std::move(watch)).first->second;
}

double ObjectStatuses::FormerLambdaAt(const Landmark& newcomer) {
  return LambdaIn(former_water_,
                  FormerWatchAt(newcomer).evidence().Lambda(params_.priors.lookalike),
                  params_.priors);
}

}  // namespace limpet
