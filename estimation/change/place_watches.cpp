// SPDX-License-Identifier: MIT
#include "estimation/change/place_watches.hpp"

#include <algorithm>
#include <utility>

#include "estimation/change/watched_place.hpp"
#include "estimation/change/water_from_places.hpp"
#include "limpet/core/require.hpp"

namespace limpet {

void PlaceWatches::Add(ObservedFrame frame, const MergedLandmarks& landmarks) {
  LIMPET_REQUIRE(frames_.empty() || frame.exposure >= frames_.back().exposure,
                 "frames out of order");
  for (auto& [landmark, watch] : landmark_) {
    watch.See(frame, model_, OwnerFor(landmark, landmarks));
  }
  for (std::optional<PlaceWatch>& watch : former_) {
    if (watch) watch->See(frame, model_, OwnerForFormer(landmarks));
  }
  frames_.push_back(std::move(frame));
}

void PlaceWatches::Move(const std::function<Pose(double t, const Pose& X_WB)>& moved) {
  for (ObservedFrame& frame : frames_) {
    frame.X_WB = moved(frame.exposure.value(), frame.X_WB);
  }
  is_anew_ = true;
}

void PlaceWatches::JudgeAnew(double false_per_image) {
  model_.look.detection.false_per_image = false_per_image;
  is_anew_ = true;
}

void PlaceWatches::Watch(const MergedLandmarks& landmarks, const FormerTies* ties,
                         bool are_owners_new) {
  if (is_anew_) landmark_.clear();
  FollowLandmarks(landmarks);
  // Who owns a box depends on which landmarks there are.
  if (ties != nullptr) FollowFormer(*ties, landmarks, is_anew_ || are_owners_new);
  is_anew_ = false;
}

void PlaceWatches::FollowLandmarks(const MergedLandmarks& landmarks) {
  std::erase_if(landmark_, [&](const auto& entry) {
    return landmarks.Representative(entry.first) != entry.first;
  });
  for (const Landmark& object : landmarks.objects()) {
    const auto found = landmark_.find(object.id);
    const ObjectEstimate place = WatchedPlace(object.object);
    if (found != landmark_.end() && !HasMoved(found->second, place)) continue;
    PlaceWatch watch(place, looks_);
    Replay(watch, OwnerFor(object.id, landmarks));
    landmark_.insert_or_assign(object.id, std::move(watch));
  }
}

void PlaceWatches::FollowFormer(const FormerTies& ties, const MergedLandmarks& landmarks,
                                bool is_anew) {
  former_.resize(ties.former().size());
  for (std::size_t i = 0; i < former_.size(); ++i) {
    std::optional<PlaceWatch>& watch = former_[i];
    if (ties.NowOf(i) && ties.SumOfFormer(i) >= 1.0) {
      watch.reset();
      continue;
    }
    const ObjectEstimate place = ties.PlaceNow(i);
    if (is_anew || !watch || HasMoved(*watch, place)) {
      watch.emplace(place, looks_);
      Replay(*watch, OwnerForFormer(landmarks));
    }
  }
}

void PlaceWatches::Replay(PlaceWatch& watch, const OwnerOf& owner_of) const {
  for (const ObservedFrame& frame : frames_) {
    watch.See(frame, model_, owner_of);
  }
}

const PlaceWatch* PlaceWatches::OfFormer(std::size_t former) const {
  return former_[former] ? &*former_[former] : nullptr;
}

bool PlaceWatches::IsExplained(const ObservedFrame& frame, const Box& box,
                               const MergedLandmarks& landmarks) const {
  return std::ranges::any_of(landmarks.objects(), [&](const Landmark& object) {
    const std::optional<Foresight> foresight =
        Foresee(WatchedPlace(object.object), frame.X_WB, model_);
    return foresight && foresight->Explains(box, model_.look.camera);
  });
}

OwnerOf PlaceWatches::OwnerFor(int landmark, const MergedLandmarks& landmarks) {
  return [&landmarks, landmark](const ObservedFrame&, const Box& box) {
    const std::optional<int> owner = landmarks.Representative(box.landmark);
    if (!owner) return BoxOwner::kUnknown;
    return owner == landmark ? BoxOwner::kThisPlace : BoxOwner::kAnotherPlace;
  };
}

OwnerOf PlaceWatches::OwnerForFormer(const MergedLandmarks& landmarks) const {
  // A former place is watched by itself only while no landmark stands for it, so every confirmed
  // landmark is another object; also in frames from before it was confirmed.
  return [this, &landmarks](const ObservedFrame& frame, const Box& box) {
    const bool is_another =
        landmarks.Representative(box.landmark) || IsExplained(frame, box, landmarks);
    return is_another ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

void PlaceWatches::Teach(VisibilityBelief& water) const {
  constexpr double kAsLikelyAsNot = 0.5;
  for (const auto& [landmark, watch] : landmark_) {
    LearnWater(watch, kAsLikelyAsNot, water);
  }
  for (const std::optional<PlaceWatch>& watch : former_) {
    if (watch) LearnWater(*watch, kAsLikelyAsNot, water);
  }
}

}  // namespace limpet
