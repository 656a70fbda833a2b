// SPDX-License-Identifier: MIT
// What boxes showed again and again, and no place was found for.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/tracked_object.hpp"
#include "limpet/objects/box.hpp"

namespace limpet {

struct UnplacedObject {
  std::string color;
  int boxes = 0;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< where it was looked for last, metres off
};

/// Boxes, many and sure, that led to no landmark: of what is so large and near that no image holds
/// it, of what moves, or of what is of quite another size than believed.
class UnplacedObjects {
 public:
  /// `least_log_odds`: of boxes that are sure, the sum of ln(c / (1 - c)).
  explicit UnplacedObjects(double least_log_odds) : least_log_odds_(least_log_odds) {}

  /// A tentative track that is about to be dropped.
  void NoteDropped(const TrackedObject& track);
  /// A box of no track that is cut too much to begin one, from `p_W`.
  void NoteUnusable(const Box& box, const Eigen::Vector3d& p_W, double t);
  /// Those without a landmark near where they were looked for.
  [[nodiscard]] std::vector<UnplacedObject> Without(
      const std::vector<TrackedObject>& landmarks) const;

 private:
  /// Unusable boxes of one class, one soon after the other.
  struct Run {
    UnplacedObject object;
    double log_odds = 0.0, last = 0.0;
  };
  void Add(const UnplacedObject& object);

  double least_log_odds_;
  Run run_;
  std::vector<UnplacedObject> objects_;
};

}  // namespace limpet
