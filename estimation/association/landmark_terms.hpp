// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/association/track_list.hpp"
#include "estimation/association/tracker_params.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// The tracks' part of the factor graph: their variables, the terms of their observations, and the
/// ties between tracks that are taken for one object. All must outlive it.
class LandmarkTerms {
 public:
  LandmarkTerms(Smoother& smoother, CameraMount& mount, const ObjectTrackerParams& params,
                TrackList& tracks)
      : smoother_(smoother),
        mount_(mount),
        params_(params),
        tracks_(tracks),
        sizes_(params.model.size_spread, smoother) {}

  /// Sizes of the mapped tracks' objects.
  [[nodiscard]] ObjectSizes& sizes() { return sizes_; }
  [[nodiscard]] const ObjectSizes& sizes() const { return sizes_; }

  /// Puts a tentative track into the smoother.
  void Map(TrackedObject& object, const TrackState& as);
  /// The terms of a mapped track's observation; the seabed's once per pass.
  void AddTerms(const TrackedObject& object, Observation& observation, bool with_seabed);
  void RemoveTerms(Observation& observation);
  /// The object is known to move by so much (1-sigma per axis [m]) from now on: its looks say
  /// little of where the vehicle is.
  void NoteMotion(TrackedObject& object, double motion_sd);
  /// Gives the observations of a tentative track to a mapped one.
  void MergeTentative(TrackedObject& tentative, TrackedObject& into);
  /// Gives up a mapped track, and releases what is tied to it.
  void Remove(TrackedObject& object);

  /// Holds the track at the place of another, which it is taken for.
  void Tie(TrackedObject& object, TrackedObject& to);
  /// Takes a tie back: the track is in doubt again.
  void Release(TrackedObject& object);
  /// Makes a tied track and its target one for good.
  void Absorb(TrackedObject& object);
  /// Removes the variables of absorbed tracks that nothing depends on any more, or all of them.
  /// True if there were any.
  bool RemoveAbsorbed(bool all);

 private:
  void ReleaseTiedTo(const TrackedObject& object);

  Smoother& smoother_;
  CameraMount& mount_;
  const ObjectTrackerParams& params_;
  TrackList& tracks_;
  ObjectSizes sizes_;
  int next_id_ = 1;
  /// Slots of absorbed tracks: they stay until the last trace of their observations is gone.
  std::vector<int> absorbed_slots_;
};

/// [m] 1-sigma between tied tracks.
inline constexpr double kTieSigma = 0.05;

}  // namespace limpet
