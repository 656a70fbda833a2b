// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "estimation/change/former_ties.hpp"
#include "estimation/change/merged_landmarks.hpp"
#include "estimation/change/place_watch.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/survey/sight_obstacles.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// What this session's frames say of every object that the smoother knows, and of every former one
/// that is not certainly one of these. Keeps all frames, because a landmark is confirmed only some
/// frames after it was first seen.
class PlaceWatches {
 public:
  PlaceWatches(const WatchModel& model, const LookParams& looks) : model_(model), looks_(looks) {}

  /// What stands between the camera and a place, in frames that come.
  void SetObstacles(const SightObstacles& obstacles) { model_.obstacles = obstacles; }
  /// Frames in order of time. Boxes that stand for none of `landmarks` are of unknown owner.
  void Add(ObservedFrame frame, const MergedLandmarks& landmarks);
  /// `moved` gives the new pose from time [s] and old pose. Every place is judged again when it is
  /// next watched.
  void Move(const std::function<Pose(double t, const Pose& X_WB)>& moved);

  /// With `false_per_image` boxes an image that show nothing, every place is judged again when it
  /// is next watched.
  void JudgeAnew(double false_per_image);
  /// Judges what is new or lies elsewhere from all frames, and forgets what is not watched any
  /// more. `ties`: of a change session. `are_owners_new`: other landmarks stand for objects than
  /// before.
  void Watch(const MergedLandmarks& landmarks, const FormerTies* ties, bool are_owners_new);
  /// Former objects alone, all of them from all frames.
  void WatchFormer(const FormerTies& ties, const MergedLandmarks& landmarks) {
    FollowFormer(ties, landmarks, true);
  }

  [[nodiscard]] const std::vector<ObservedFrame>& frames() const { return frames_; }
  [[nodiscard]] const WatchModel& model() const { return model_; }
  /// REQUIRES: it stands for an object that is watched.
  [[nodiscard]] const PlaceWatch& OfLandmark(int landmark) const { return landmark_.at(landmark); }
  /// nullptr for one that is certainly an object of now.
  [[nodiscard]] const PlaceWatch* OfFormer(std::size_t former) const;
  /// True if an object that lies where one of `landmarks` does could be what the box shows.
  [[nodiscard]] bool IsExplained(const ObservedFrame& frame, const Box& box,
                                 const MergedLandmarks& landmarks) const;
  /// Whose box one is for the object that `landmark` stands for.
  [[nodiscard]] static OwnerOf OwnerFor(int landmark, const MergedLandmarks& landmarks);
  /// What all of them say of the water.
  void Teach(VisibilityBelief& water) const;

 private:
  void FollowLandmarks(const MergedLandmarks& landmarks);
  void FollowFormer(const FormerTies& ties, const MergedLandmarks& landmarks, bool is_anew);
  void Replay(PlaceWatch& watch, const OwnerOf& owner_of) const;
  [[nodiscard]] OwnerOf OwnerForFormer(const MergedLandmarks& landmarks) const;

  WatchModel model_;
  LookParams looks_;
  std::vector<ObservedFrame> frames_;
  std::map<int, PlaceWatch> landmark_;  ///< by landmark that stands for an object
  std::vector<std::optional<PlaceWatch>> former_;
  bool is_anew_ = false;  ///< nothing that was judged holds any more
};

}  // namespace limpet
