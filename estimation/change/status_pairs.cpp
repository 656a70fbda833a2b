// SPDX-License-Identifier: MIT
// What an ObjectStatuses makes of its objects together: which of them are one that has moved, and
// which of the smoother's it does not have.
#include <algorithm>

#include "estimation/change/object_statuses.hpp"
#include "estimation/matching/move_hypotheses.hpp"

namespace limpet {
namespace {

struct MovedPair {
  double probability;
  double distance;  ///< [m]
  OpiBelief* removed;
  OpiBelief* appeared;
};

double DistanceOverGround(const OpiBelief& a, const OpiBelief& b) {
  return (a.object.p_W - b.object.p_W).head<2>().norm();
}

/// That the one is gone, the other came, and both are one.
double ProbabilityMoved(const OpiBelief& removed, const OpiBelief& appeared, double farthest) {
  return removed.posterior.removed * appeared.posterior.appeared *
         ChanceMoved(removed.object, appeared.object, farthest);
}

}  // namespace

void ObjectStatuses::PairMoved(std::vector<OpiBelief>& objects) const {
  const double farthest = params_.matching.moved_within.value();
  std::vector<MovedPair> pairs;
  for (OpiBelief& removed : objects) {
    if (removed.decided != Status::kRemoved) continue;
    for (OpiBelief& other : objects) {
      const double distance = DistanceOverGround(removed, other);
      if (other.decided == Status::kNew && other.object.color == removed.object.color &&
          distance < farthest) {
        pairs.push_back({ProbabilityMoved(removed, other, farthest), distance, &removed, &other});
      }
    }
  }
  std::ranges::stable_sort(pairs, [](const MovedPair& a, const MovedPair& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.distance < b.distance;
  });
  for (const MovedPair& pair : pairs) {
    if (!pair.removed->former_id || pair.appeared->decided == Status::kMoved) continue;
    pair.appeared->decided = Status::kMoved;
    pair.appeared->former_id = pair.removed->former_id;
    pair.appeared->moved_probability = pair.probability;
    pair.removed->former_id.reset();  // its story goes on in the other entry
  }
  std::erase_if(objects, [](const OpiBelief& object) {
    return object.decided == Status::kRemoved && !object.former_id;
  });
}

int ObjectStatuses::CountDoubted(const std::vector<OpiBelief>& objects) const {
  constexpr int kLeastDetections = 10;  // detections of one object
  constexpr double kLikely = 0.5;
  return static_cast<int>(std::ranges::count_if(objects_, [&](const Landmark& landmark) {
    const bool is_believed = std::ranges::any_of(objects, [&](const OpiBelief& object) {
      return object.landmark == landmark.id && object.posterior.present() >= kLikely;
    });
    return landmark.detections >= kLeastDetections && !is_believed;
  }));
}

}  // namespace limpet
