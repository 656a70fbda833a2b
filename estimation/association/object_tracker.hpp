// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "estimation/association/confirmation.hpp"
#include "estimation/association/frame_associator.hpp"
#include "estimation/association/identity_decisions.hpp"
#include "estimation/association/landmark_review.hpp"
#include "estimation/association/landmark_terms.hpp"
#include "estimation/association/track_list.hpp"
#include "estimation/association/tracker_params.hpp"
#include "estimation/association/unplaced_objects.hpp"
#include "estimation/smoothing/smoother.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// Decides which box shows which object, and what is an object at all. Tentative tracks live here;
/// confirmed ones are landmarks of the smoother, whose terms are added, moved and taken out here.
/// `FrameAssociator` assigns boxes to tracks, `Confirmation` decides what a tentative track is,
/// `IdentityDecisions` which tracks are one object, `LandmarkReview` takes out what does not fit.
class ObjectTracker {
 public:
  /// `smoother` must outlive the tracker.
  ObjectTracker(Smoother& smoother, const CameraModel& camera, const ObjectTrackerParams& params);
  ~ObjectTracker() = default;
  ObjectTracker(const ObjectTracker&) = delete;
  ObjectTracker& operator=(const ObjectTracker&) = delete;

  /// True if a box is worth a node of its own.
  [[nodiscard]] bool IsUsable(const Box& box) const;
  /// Associates the boxes of one frame; the smoother must be up to date with its node. Returns per
  /// box the id of the landmark that it shows, if any. The smoother is to be updated afterwards if
  /// it returns any.
  [[nodiscard]] std::vector<std::optional<int>> Process(const Detections& frame,
                                                        const Viewpoint& from);
  /// After an update: takes out observations that do not fit, merges duplicates, drops false
  /// landmarks. True if the graph changed.
  bool Review();
  /// The session is over: decides what is still in doubt as well as can be. True if the graph
  /// changed.
  bool Conclude() { return identities_.Conclude(); }
  /// Copies estimates from the smoother: of what the vehicle may see soon at once, of what is far
  /// from it one by one.
  void Refresh();
  /// Copies the estimates of all objects from the smoother at once.
  void RefreshAll();

  [[nodiscard]] const std::vector<TrackedObject>& objects() const { return tracks_.objects; }
  [[nodiscard]] std::vector<TrackedObject>& objects() { return tracks_.objects; }
  [[nodiscard]] const CameraMount& mount() const { return mount_; }
  /// Nothing if sizes are taken for known.
  [[nodiscard]] std::optional<ObjectSize> SizeOf(const TrackedObject& landmark) const;
  [[nodiscard]] BoxesTogether BoxesOf(const TrackedObject& landmark) const {
    return tracks_.BoxesOf(landmark);
  }
  [[nodiscard]] int rejected_observations() const { return review_.rejected(); }
  /// What boxes showed again and again without a place that they agree on.
  [[nodiscard]] std::vector<UnplacedObject> Unplaced() const {
    return unplaced_.Without(tracks_.objects);
  }

 private:
  [[nodiscard]] std::vector<Candidate> CandidatesOf(const Detections& frame) const;
  void AddObservation(TrackedObject& object, Observation observation, const Viewpoint& from);
  void StartTrack(Observation observation, const Viewpoint& from);
  void LearnSizes();
  void Refresh(TrackedObject& object);
  /// Tells the smoother what may be asked about with the poses to come.
  void KeepNearAtHand();
  /// Tentative tracks that nothing has shown for long.
  void DropStale();

  Smoother& smoother_;
  ObjectTrackerParams params_;
  CameraMount mount_;
  TrackList tracks_;
  LandmarkTerms terms_;
  FrameAssociator associator_;
  Confirmation confirmation_;
  LandmarkReview review_;
  IdentityDecisions identities_;
  UnplacedObjects unplaced_{params_.confirm_log_odds};
  std::size_t next_far_ = 0;  ///< whose turn it is to be refreshed
  int refreshes_ = 0;         ///< since the last one that was far
};

}  // namespace limpet
