// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/association/joint_identity.hpp"
#include "estimation/association/landmark_terms.hpp"
#include "limpet/core/long_ago.hpp"

namespace limpet {

/// Which tracks in doubt are landmarks known before: decided jointly, as multiple hypotheses
/// [Reid 1979] over all that is open, with all correlations [Neira 2001]. Tracks in doubt are in
/// the graph from the start, each for itself, so that all that is learnt later counts; what is
/// taken for another is tied to it, and the tie is taken back when the rest no longer agrees.
class IdentityDecisions {
 public:
  /// All must outlive it.
  IdentityDecisions(Smoother& smoother, const ObjectTrackerParams& params, TrackList& tracks,
                    LandmarkTerms& terms)
      : smoother_(smoother), params_(params), tracks_(tracks), terms_(terms) {}

  /// Decides what is clear, where a decision is due. True if the graph changed.
  bool DecideWhatIsDue();
  /// Nothing more is to come: decides as well as can be, and merges what is tied for good. True if
  /// the graph changed.
  bool Conclude();

 private:
  enum class Occasion { kOngoing, kEnd };
  /// Open tracks, oldest first, then what they may be; and the hypotheses on their identities.
  struct Joint {
    std::vector<TrackedObject*> tracks;
    IdentityProblem problem;
    std::vector<IdentityHypothesis> hypotheses;
    [[nodiscard]] int claimants() const { return static_cast<int>(problem.claimants.size()); }
    [[nodiscard]] TrackedObject& track(int i) const { return *tracks[static_cast<std::size_t>(i)]; }
  };
  /// How the likelihood of one claimant's identities is shared out.
  struct Shares {
    int best = 0;  ///< index of the track that it likeliest is; its own: none of the others
    double of_best = 0.0;
    double of_tie = 0.0;     ///< that it is the track that it is tied to
    double of_rivals = 0.0;  ///< of all other known landmarks together
  };
  bool Decide(Occasion occasion);
  /// True if what it is may be decided: it has been seen enough, or is out of view.
  [[nodiscard]] bool IsDecidable(const TrackedObject& object, Occasion occasion) const;
  [[nodiscard]] int CountDecidable(Occasion occasion) const;
  [[nodiscard]] bool IsDue(int ready) const;
  /// So that a decision stays cheap: landmarks of the greatest share leave probation, the oldest
  /// doubt is given up. True if the graph changed.
  bool LimitOpen();
  void EndProbationOfBest(std::vector<TrackedObject*> landmarks);
  bool GiveUpOldest(std::vector<TrackedObject*> in_doubt);
  [[nodiscard]] Joint Collect(Occasion occasion);
  /// Appends the landmarks that the claimants may be.
  void AddOptions(std::vector<TrackedObject*>& tracks);
  /// Places and covariance as if nothing were tied. False if that cannot be had.
  [[nodiscard]] bool FillPlaces(Joint& joint, int claimants) const;
  void AddClaimants(Joint& joint, int claimants) const;
  [[nodiscard]] IdentityProblem::Claimant ClaimantOf(
      int i, const Joint& joint, std::vector<IdentityProblem::Apart>& apart) const;
  [[nodiscard]] static Shares SharesOf(int claimant, const Joint& joint);
  /// True if the graph changed.
  bool Apply(const Joint& joint, Occasion occasion);
  bool ApplyTo(int claimant, const Joint& joint, Occasion occasion);
  void EndProbation(const Joint& joint);
  void NoteProvisional();
  /// Merges tied tracks that are one beyond doubt, or too many. True if any.
  bool AbsorbProven(const Joint& joint);

  Smoother& smoother_;
  const ObjectTrackerParams& params_;
  TrackList& tracks_;
  LandmarkTerms& terms_;
  double decided_t_ = kLongAgo;  ///< of the last decision [s]
  int decidable_then_ = 0;
};

}  // namespace limpet
