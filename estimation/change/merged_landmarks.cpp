// SPDX-License-Identifier: MIT
#include "estimation/change/merged_landmarks.hpp"

#include <algorithm>
#include <cstddef>

#include "estimation/change/distance_over_ground.hpp"

namespace limpet {

void MergedLandmarks::NoteSeenTogether(const ObservedFrame& frame) {
  for (std::size_t i = 0; i < frame.boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < frame.boxes.size(); ++j) {
      const std::optional<int>&a = frame.boxes[i].landmark, &b = frame.boxes[j].landmark;
      if (a && b) seen_together_.insert(std::minmax(*a, *b));
    }
  }
}

bool MergedLandmarks::Set(std::vector<Landmark> landmarks) {
  // Whoever was detected most often stands for the others.
  std::ranges::sort(landmarks, {}, &Landmark::id);
  std::ranges::stable_sort(
      landmarks, [](const Landmark& a, const Landmark& b) { return a.detections > b.detections; });
  objects_.clear();
  std::map<int, int> before;
  before.swap(representatives_);
  for (const Landmark& landmark : landmarks) {
    const auto same = std::ranges::find_if(
        objects_, [&](const Landmark& object) { return AreOne(object, landmark); });
    representatives_[landmark.id] = same == objects_.end() ? landmark.id : same->id;
    if (same == objects_.end()) {
      objects_.push_back(landmark);
    } else if (landmark.former.is_decided() || !same->former.is_possible()) {
      same->former = landmark.former;
    }
  }
  std::ranges::sort(objects_, {}, &Landmark::id);
  return representatives_ != before;
}

std::optional<int> MergedLandmarks::Representative(const std::optional<int>& landmark) const {
  if (!landmark) return std::nullopt;
  const auto found = representatives_.find(*landmark);
  return found == representatives_.end() ? std::nullopt : std::optional(found->second);
}

bool MergedLandmarks::AreOne(const Landmark& a, const Landmark& b) const {
  const bool are_two_former =
      a.former.is_decided() && b.former.is_decided() && a.former.id != b.former.id;
  return !are_two_former && DistanceOverGround(a.object, b.object) < within_ &&
         !seen_together_.contains(std::minmax(a.id, b.id));
}

}  // namespace limpet
