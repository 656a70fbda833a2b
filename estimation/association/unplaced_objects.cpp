// SPDX-License-Identifier: MIT
#include "estimation/association/unplaced_objects.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr int kManyBoxes = 12;               // three seconds in sight at 4 Hz
constexpr double kRunPause = 5.0;            // [s] between boxes of one thing
constexpr double kNear = 3.0;                // [m], level
constexpr double kMostSure = 0.99;           // no box is surer than that
constexpr std::size_t kMostRemembered = 64;  // the oldest go first
constexpr Interval kCredible{.low = 1.0 - kMostSure, .high = kMostSure};

}  // namespace

void UnplacedObjects::Add(const UnplacedObject& object) {
  // What is seen on is the same still.
  const auto again = std::ranges::find_if(objects_, [&object](const UnplacedObject& one) {
    return one.color == object.color && (one.p_W - object.p_W).head<2>().norm() < kNear;
  });
  if (again != objects_.end()) {
    again->boxes += object.boxes;
    return;
  }
  if (objects_.size() == kMostRemembered) objects_.erase(objects_.begin());
  objects_.push_back(object);
}

void UnplacedObjects::NoteDropped(const TrackedObject& track) {
  const int boxes = static_cast<int>(track.observations.size());
  if (boxes < kManyBoxes || track.observations.LogOdds() < least_log_odds_) return;
  Add({.color = track.color(), .boxes = boxes, .p_W = track.p_W});
}

void UnplacedObjects::NoteUnusable(const Box& box, const Eigen::Vector3d& p_W, double t) {
  if (box.color != run_.object.color || t - run_.last > kRunPause)
    run_ = {.object = {.color = box.color, .boxes = 0, .p_W = p_W}};
  run_.log_odds += LogOddsOf(box.confidence, kCredible);
  run_.last = t;
  ++run_.object.boxes;
  if (run_.object.boxes < kManyBoxes || run_.log_odds < least_log_odds_) return;
  Add(run_.object);
  run_ = {};
}

std::vector<UnplacedObject> UnplacedObjects::Without(
    const std::vector<TrackedObject>& landmarks) const {
  std::vector<UnplacedObject> left;
  std::ranges::copy_if(objects_, std::back_inserter(left), [&](const UnplacedObject& one) {
    return std::ranges::none_of(landmarks, [&one](const TrackedObject& landmark) {
      return landmark.is_mapped() && (landmark.p_W - one.p_W).head<2>().norm() < kNear;
    });
  });
  return left;
}

}  // namespace limpet
