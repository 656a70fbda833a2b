// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/association/landmark_terms.hpp"

namespace limpet {

/// Second thoughts after an update: observations that do not fit, landmarks that may be one,
/// landmarks that are none. All must outlive it.
class LandmarkReview {
 public:
  LandmarkReview(Smoother& smoother, const CameraMount& mount, const ObjectTrackerParams& params,
                 TrackList& tracks, LandmarkTerms& terms)
      : smoother_(smoother), mount_(mount), params_(params), tracks_(tracks), terms_(terms) {}

  /// Takes out observations that do not fit; those that agree among themselves are another object
  /// after all. True if the graph changed.
  bool RemoveOutliers();
  /// Puts in doubt which of two landmarks is likely the other one. True if the graph changed.
  bool DoubtDuplicates();
  /// Gives up landmarks that too few frames show. True if the graph changed.
  bool DropFalseLandmarks();
  [[nodiscard]] int rejected() const { return rejected_; }

 private:
  /// True if the two show one object that moves: each is gone where the other is seen.
  [[nodiscard]] bool AreOneThatMoves(const TrackedObject& a, const TrackedObject& b) const;
  /// Notes it unless as much was known before; true if not.
  bool NoteMotion(TrackedObject& object, double motion_sd);
  /// True if the object is found to move, or to move more than was known.
  bool NoteMotion(TrackedObject& object);
  /// Takes the observations out of the track that do not fit its place.
  [[nodiscard]] std::vector<Observation> TakeOutliers(TrackedObject& object);
  void SplitOff(std::vector<Observation> outliers, const TrackedObject& from,
                std::vector<TrackedObject>& split);
  [[nodiscard]] bool AreLikelyOne(const TrackedObject& a, const TrackedObject& b,
                                  const Eigen::Matrix3d& difference_W) const;

  Smoother& smoother_;
  const CameraMount& mount_;
  const ObjectTrackerParams& params_;
  TrackList& tracks_;
  LandmarkTerms& terms_;
  int rejected_ = 0;  ///< observations, since the start
};

}  // namespace limpet
