// SPDX-License-Identifier: MIT
#include "estimation/change/moved_pairs.hpp"

#include <algorithm>

#include "estimation/change/distance_over_ground.hpp"
#include "estimation/matching/move_hypotheses.hpp"

namespace limpet {
namespace {

struct MovedPair {
  double probability;
  double distance;  ///< [m]
  OpiBelief* removed;
  OpiBelief* appeared;
};

/// That the one is gone, the other came, and both are one.
double ProbabilityMoved(const OpiBelief& removed, const OpiBelief& appeared, double farthest) {
  return removed.posterior.removed * appeared.posterior.appeared *
         ChanceMoved(removed.object, appeared.object, farthest);
}

}  // namespace

void PairMoved(std::vector<OpiBelief>& objects, double farthest) {
  std::vector<MovedPair> pairs;
  for (OpiBelief& removed : objects) {
    if (removed.decided != Status::kRemoved) continue;
    for (OpiBelief& other : objects) {
      const double distance = DistanceOverGround(removed.object, other.object);
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

}  // namespace limpet
