// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/tracked_object.hpp"

namespace limpet {

/// What the boxes of a track and of those tied to it say together.
struct BoxesTogether {
  int count = 0;
  std::string color;  ///< the class with the most votes; the first in the alphabet if equal
};

/// All tracks, and what the tracker's parts know together.
class TrackList {
 public:
  std::vector<TrackedObject> objects;
  double now = 0.0;  ///< of the last frame [s]
  /// True while a track is tied to another one that it may not be: then the pose is not as certain
  /// as its covariance says, and what is seen again is mapped in doubt.
  bool is_provisional = false;
  int identity_news = 0;  ///< since identities were last decided

  [[nodiscard]] TrackedObject* FindById(int id);
  /// Id of the landmark that the track is; nothing while that is in doubt.
  [[nodiscard]] std::optional<int> LandmarkIdOf(const TrackedObject& object) const;
  /// What is known of an object as long as its ties hold.
  [[nodiscard]] BoxesTogether BoxesOf(const TrackedObject& object) const;
  /// Untied tracks within a distance [m].
  [[nodiscard]] std::vector<TrackedObject*> UntiedNear(const Eigen::Vector3d& p_W, double distance);
  /// True if boxes may show this track, and not another that is tied to it and was seen within
  /// `pause` seconds: that one keeps the boxes of its own pass, so that they come away with it.
  [[nodiscard]] bool TakesObservations(const TrackedObject& object, double pause) const;
  /// Erases tracks without observations.
  void EraseEmpty();
};

/// How landmarks cluster: where objects come in pairs, another one beside a known one is no
/// surprise.
struct Clustering {
  double pair_density = 0.0;  ///< of objects beside one that has none there yet [1/m^3]
  double crowding = 0.0;      ///< share of it beside one that has
};
[[nodiscard]] Clustering ClusteringOf(const std::vector<TrackedObject>& objects,
                                      double pair_distance);
/// Landmarks within a distance [m] of the object, itself not counted.
[[nodiscard]] int CountNeighbours(const TrackedObject& object,
                                  const std::vector<TrackedObject>& objects, double distance);

}  // namespace limpet
