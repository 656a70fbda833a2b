// SPDX-License-Identifier: MIT
// What a StatusBook makes of the former session: its objects, its frame, and what it would have
// seen.
#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/change/status_book.hpp"
#include "estimation/change/watched_place.hpp"
#include "estimation/matching/own_covariance.hpp"

namespace limpet {

void StatusBook::SetFormer(std::vector<FormerObject> former) {
  former_watch_.assign(former.size(), std::nullopt);
  former_ = std::move(former);
  // Former objects take the first ids, so that they keep them when they are found again.
  next_id_ = std::max(next_id_, static_cast<int>(former_->size()) + 1);
  MatchFormer();
  WatchFormer(true);
}

void StatusBook::SetFormerViews(FormerViews views) {
  former_views_ = std::move(views);
  former_lambda_.clear();
}

OwnerOf StatusBook::OwnerForFormer() const {
  // A former place is watched by itself only while no landmark stands for it, so every confirmed
  // landmark is another object; also in frames from before it was confirmed.
  return [this](const ObservedFrame& sight, const Box& box) {
    const bool is_another = Representative(box.landmark) >= 0 || IsExplained(sight, box);
    return is_another ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

void StatusBook::MatchFormer() {
  std::vector<ObjectEstimate> former;
  std::vector<ObjectEstimate> now;
  for (const FormerObject& object : *former_) {
    former.push_back(object.object);
  }
  for (const Landmark& object : objects_) {
    now.push_back(object.object);
  }
  match_ = MatchSessions(WithOwnCovariance(std::move(former)), WithOwnCovariance(std::move(now)),
                         params_.matching);
}

ObjectEstimate StatusBook::InOtherFrame(ObjectEstimate place, const Eigen::Vector3d& ned) const {
  const double own = std::pow(params_.matching.position_floor.value(), 2);
  place.p_W = ned;
  place.cov_W = own * Eigen::Matrix3d::Identity();
  place.cov_W.topLeftCorner<2, 2>() += match_.shift_cov;
  return place;
}

ObjectEstimate StatusBook::FormerPlace(std::size_t index) const {
  const ObjectEstimate& former = (*former_)[index].object;
  return InOtherFrame(former, match_.offset.Apply(former.p_W));
}

void StatusBook::WatchFormer(bool rejudges_all) {
  for (std::size_t i = 0; i < former_->size(); ++i) {
    std::optional<PlaceWatch>& watch = former_watch_[i];
    if (match_.now_of_former[i] >= 0) {
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

OwnerOf StatusBook::OwnerInFormerViews() const {
  return [this](const ObservedFrame& view, const Box& box) {
    const bool is_listed = std::ranges::any_of(*former_, [&](const FormerObject& former) {
      const std::optional<Foresight> foresight =
          Foresee(WatchedPlace(former.object), view.X_WB, former_views_.model);
      return foresight && foresight->Explains(box, former_views_.model.camera);
    });
    return is_listed ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

double StatusBook::FormerLambdaAt(const Landmark& newcomer) {
  const ObjectEstimate place =
      InOtherFrame(newcomer.object, match_.offset.Undo(newcomer.object.p_W));
  const auto known = former_lambda_.find(newcomer.id);
  if (known != former_lambda_.end() && !HasMoved(known->second, place)) {
    return known->second.Lambda();
  }
  PlaceWatch watch(place, former_views_.looks);
  const OwnerOf owner_of = OwnerInFormerViews();
  for (const ObservedFrame& view : former_views_.sights) {
    watch.See(view, former_views_.model, owner_of);
  }
  const double lambda = watch.Lambda();
  former_lambda_.insert_or_assign(newcomer.id, std::move(watch));
  return lambda;
}

}  // namespace limpet
