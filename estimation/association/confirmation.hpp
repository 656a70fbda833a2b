// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/association/frame_associator.hpp"
#include "estimation/association/landmark_terms.hpp"

namespace limpet {

/// Decides what a tentative track is that enough boxes agree on: a landmark that is known already,
/// a new one, or in doubt. Decided on its place, from several boxes at once: where the pose is
/// uncertain, one box alone could be anything. All must outlive it.
class Confirmation {
 public:
  Confirmation(const Smoother& smoother, const ObjectTrackerParams& params, TrackList& tracks,
               LandmarkTerms& terms)
      : smoother_(smoother), params_(params), tracks_(tracks), terms_(terms) {}

  /// `x`: the newest pose.
  void ConfirmWhatIsDue(const NavVector& x);

 private:
  /// How many observations, and how certain ones, must agree.
  struct Quorum {
    int observations;
    double log_odds;
    bool counts_cut_boxes;  ///< also boxes that both borders cut
  };
  /// Evidence that a tentative track is a known landmark.
  struct PairLikelihood {
    double cost = 0.0;       ///< -2 ln of the likelihood that they are one
    double distance2 = 0.0;  ///< squared Mahalanobis distance
    double drift_sd = 0.0;   ///< 1-sigma of their distance, horizontal [m]
  };
  /// Enough for an object that nothing else speaks for.
  [[nodiscard]] Quorum QuorumOfNew() const;
  /// Fewer boxes tell an object that is known and expected there.
  [[nodiscard]] Quorum QuorumOfKnown() const;
  /// How many boxes that show a whole axis one is worth.
  [[nodiscard]] double WorthOf(const BoxReading& reading, const Quorum& quorum) const;
  [[nodiscard]] bool HasQuorum(const TrackedObject& object, const Quorum& quorum) const;
  /// Ln of the odds that it is an object: from confidences, and from frames that do not show it.
  [[nodiscard]] double LogOddsOf(const TrackedObject& object) const;
  [[nodiscard]] PairLikelihood LikelihoodOf(const TrackedObject& tentative,
                                            const TrackedObject& landmark,
                                            const NavVector& x) const;
  [[nodiscard]] std::vector<TrackedObject*> LandmarksNear(const Eigen::Vector3d& p_W);
  /// True if it may be a landmark that drift could have put elsewhere: then it is mapped in doubt,
  /// and decided with what is seen beside it.
  [[nodiscard]] bool MayHaveDrifted(TrackedObject& object, const NavVector& x);
  /// Where the pose is certain: a known landmark, a new one, or one in doubt.
  void Decide(TrackedObject& object, const NavVector& x);

  const Smoother& smoother_;
  const ObjectTrackerParams& params_;
  TrackList& tracks_;
  LandmarkTerms& terms_;
};

}  // namespace limpet
