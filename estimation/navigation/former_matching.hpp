// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "estimation/association/object_tracker.hpp"
#include "estimation/navigation/former_session_tie.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Finds the former session's objects among the tracker's landmarks, anew whenever those have
/// changed, and gives the smoother what it knew of their places. `smoother` and `tracker` must
/// outlive it.
class FormerMatching {
 public:
  FormerMatching(const MatchingParams& params, Smoother& smoother, ObjectTracker& tracker)
      : tie_(params), smoother_(smoother), tracker_(tracker) {}

  void SetFormer(FormerSession former);
  [[nodiscard]] bool has_former() const { return tie_.has_former(); }
  /// Matches and updates the smoother, if landmarks have changed since the last match.
  void Update();
  /// Offset of the former session's frame in this one; as it was before any match.
  [[nodiscard]] FrameOffset offset() const { return tie_.offset(); }
  [[nodiscard]] bool is_elsewhere() const { return tie_.is_elsewhere(); }

 private:
  struct MatchedLandmark {
    int slot;
    Eigen::Vector3d p_W;
    std::string color;
    std::size_t undecided_at;  ///< its observations if it was undecided, else 0
  };
  struct Present {
    std::vector<TrackedObject*> objects;
    PresentLandmarks landmarks;
  };
  /// Landmarks, then those that have come in doubt since the prior was applied.
  [[nodiscard]] Present CollectPresent();
  [[nodiscard]] bool HasChanged(const Present& present) const;

  FormerSessionTie tie_;
  Smoother& smoother_;
  ObjectTracker& tracker_;
  std::vector<MatchedLandmark> matched_;  ///< as of the last match
};

}  // namespace limpet
