// SPDX-License-Identifier: MIT
#include "estimation/association/track_list.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace limpet {

TrackedObject* TrackList::FindById(int id) {
  const auto found = std::ranges::find_if(objects, [id](const TrackedObject& object) {
    return !object.Is<Tentative>() && object.id() == id;
  });
  return found == objects.end() ? nullptr : &*found;
}

std::optional<int> TrackList::LandmarkIdOf(const TrackedObject& object) const {
  if (object.is_landmark()) return object.id();
  const std::optional<int> to = object.tied_to();
  const auto target = std::ranges::find_if(objects, [&to](const TrackedObject& other) {
    return to && !other.Is<Tentative>() && other.id() == *to;
  });
  return target == objects.end() ? std::nullopt : LandmarkIdOf(*target);
}

BoxesTogether TrackList::BoxesOf(const TrackedObject& object) const {
  BoxesTogether boxes{.count = static_cast<int>(object.observations.size()),
                      .color = object.color()};
  if (!object.is_mapped()) return boxes;
  std::map<std::string, double> votes;
  for (const TrackedObject& other : objects) {
    if (!other.Is<Tied>() || LandmarkIdOf(other) != object.id()) continue;
    if (votes.empty()) votes = object.observations.votes();
    for (const auto& [name, of_other] : other.observations.votes())
      votes[name] += of_other;
    boxes.count += static_cast<int>(other.observations.size());
  }
  if (!votes.empty()) {
    const auto of_vote = [](const auto& vote) { return vote.second; };
    boxes.color = std::ranges::max_element(votes, {}, of_vote)->first;
  }
  return boxes;
}

std::vector<TrackedObject*> TrackList::UntiedNear(const Eigen::Vector3d& p_W, double distance) {
  std::vector<TrackedObject*> near;
  for (TrackedObject& object : objects) {
    if (object.is_untied() && (object.p_W - p_W).norm() < distance) near.push_back(&object);
  }
  return near;
}

bool TrackList::TakesObservations(const TrackedObject& object, double pause) const {
  const auto is_in_its_pass = [&](const TrackedObject& tied) {
    return tied.Is<Tied>() && now - tied.last_seen() <= pause;
  };
  if (object.Is<Tied>()) return is_in_its_pass(object);
  return object.is_mapped() && std::ranges::none_of(objects, [&](const TrackedObject& other) {
           return other.IsTiedTo(object.id()) && is_in_its_pass(other);
         });
}

void TrackList::EraseEmpty() {
  std::erase_if(objects, [](const TrackedObject& object) { return object.observations.empty(); });
}

int CountNeighbours(const TrackedObject& object, const std::vector<TrackedObject>& objects,
                    double distance) {
  return static_cast<int>(std::ranges::count_if(objects, [&](const TrackedObject& other) {
    return other.is_landmark() && &other != &object && (other.p_W - object.p_W).norm() < distance;
  }));
}

Clustering ClusteringOf(const std::vector<TrackedObject>& objects, double pair_distance) {
  constexpr double kUnpaired = 4.0;  // landmarks without a neighbour that count before any is known
  constexpr double kCrowded = 0.5, kPaired = 2.0;  // likewise, of those with more than one
  constexpr double kOwnHeight = 1.0;               // [m] that objects of one place differ in
  double paired = 0.0, crowded = kCrowded, all = kUnpaired;
  for (const TrackedObject& object : objects) {
    if (!object.is_landmark()) continue;
    const int neighbours = CountNeighbours(object, objects, pair_distance);
    all += 1.0;
    paired += neighbours > 0 ? 1.0 : 0.0;
    crowded += neighbours > 1 ? 1.0 : 0.0;
  }
  const double volume = std::numbers::pi * pair_distance * pair_distance * kOwnHeight;
  return {.pair_density = paired / all / volume, .crowding = crowded / (paired + kPaired)};
}

}  // namespace limpet
