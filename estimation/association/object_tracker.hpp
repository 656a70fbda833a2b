// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/association/box_gate.hpp"
#include "estimation/association/detection.hpp"
#include "estimation/association/triangulation.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

struct ObjectTrackerParams {
  ObjectModel model;
  BoxGateParams gate;
  double min_confidence = 0.45;  ///< boxes below are not used
  int looks_to_confirm = 3;
  double confirm_log_odds = 2.5;  ///< sum of ln(c / (1 - c)) over the looks' confidences
  double confirm_sd_m = 0.8;      ///< worst 1-sigma of the place, else more looks are needed
  double confirm_residual = 3.5;  ///< worst whitened residual of a look
  double place_prior_m = 3.0;     ///< weak hold on a landmark where its first pose saw it
  double confirm_within_s = 20.0;
  double confirm_hit_share = 0.25;  ///< of the frames that should have shown it
  double drop_hit_share = 0.1;      ///< a landmark seen in fewer is a false one
  int drop_after_expected = 40;
  /// A box is taken for a landmark at once when the landmark was expected within this share of the
  /// box's size; else several boxes must first agree among themselves.
  double sure_share = 0.2;
  double known_margin = 10.0;     ///< -2 ln of the likelihood ratio that tells a known object
  double sure_spread_m = 0.3;     ///< drift below which three boxes are enough for that
  double drift_share = 0.01;      ///< of the way since last seen, for tentative objects
  double outlier_sigma = 6.0;     ///< a look that fits worse after solving is taken out again
  double merge_distance_m = 2.5;  ///< landmarks further apart are never one
  double objects_per_m3 = 1e-3;   ///< how crowded the water is
  double beside_m = 2.0;          ///< objects this near each other come in groups
};

/// One frame at a pose: what the tracker works on.
struct TrackerFrame {
  const FrameDetections* detections = nullptr;
  NavVector x = NavVector::Zero();
  int node = -1;  ///< of the chain, newest; -1 when the frame has no usable box
  double path = 0.0;
  std::optional<double> altitude;  ///< of the body origin above the seabed [m]
};

/// Decides which box shows which object, and what is an object at all. Tentative objects live here;
/// confirmed ones are landmarks of the smoother, whose terms are added, moved and taken out here.
class ObjectTracker {
 public:
  /// `smoother` must outlive the tracker.
  ObjectTracker(Smoother& smoother, const CameraModel& camera, const ObjectTrackerParams& params);

  /// True if a box is worth a node of its own.
  [[nodiscard]] bool IsUsable(const BoxDetection& box) const;
  /// Associates the boxes of one frame; the smoother must be up to date with its node. Returns per
  /// box the landmark's id, or -1. The smoother is to be updated afterwards if it returns any.
  [[nodiscard]] std::vector<int> Process(const TrackerFrame& frame);
  /// After an update: takes out looks that do not fit, merges duplicates, drops false landmarks.
  /// True if the graph changed.
  bool Review();
  /// The session is over: decides what is still in doubt as well as can be. True if the graph
  /// changed.
  bool Conclude();
  /// Copies landmark estimates from the smoother.
  void Refresh();

  [[nodiscard]] const std::vector<TrackedObject>& objects() const { return objects_; }
  [[nodiscard]] std::vector<TrackedObject>& objects() { return objects_; }
  [[nodiscard]] int rejected_looks() const { return rejected_looks_; }

 private:
  struct Candidate {
    int detection;
    BoxReading reading;
  };
  [[nodiscard]] Eigen::MatrixXd Costs(const TrackerFrame& frame,
                                      const std::vector<Candidate>& candidates) const;
  [[nodiscard]] SightCovariance CovarianceWith(const TrackedObject& object, double path,
                                               const Eigen::MatrixXd& joint, int row) const;
  /// True if boxes may show this landmark, and not another that is tied to it.
  [[nodiscard]] bool TakesLooks(const TrackedObject& object) const;
  /// Id of the landmark that it is, or -1 while that is in doubt.
  [[nodiscard]] int NameOf(const TrackedObject& object) const;
  [[nodiscard]] bool IsSeenAgain(const TrackedObject& object) const {
    return now_ - object.last_seen() > params_.confirm_within_s;
  }
  void CountVisibility(const TrackerFrame& frame, const std::vector<int>& seen);
  void AddLook(TrackedObject& object, Look look, const TrackerFrame& frame);
  void Start(Look look, const TrackerFrame& frame);
  /// True if enough boxes agree on a tentative object.
  [[nodiscard]] bool IsRipe(const TrackedObject& object, double now) const {
    return AgreeOn(object, params_.looks_to_confirm, params_.confirm_log_odds, now);
  }
  /// Ln of the odds that it is an object: from confidences, and from frames that do not show it.
  [[nodiscard]] double Belief(const TrackedObject& object) const;
  [[nodiscard]] bool AgreeOn(const TrackedObject& object, int boxes, double log_odds,
                             double now) const;
  /// Decides what ripe objects are: known landmarks or new ones.
  void ConfirmWhatIsDue(const TrackerFrame& frame);
  struct Likeness {
    double cost = 0.0;       ///< -2 ln of the likelihood that they are one
    double distance2 = 0.0;  ///< squared Mahalanobis distance
    double spread = 0.0;     ///< 1-sigma of their distance, horizontal [m]
  };
  [[nodiscard]] Likeness LikenessOf(const TrackedObject& tentative, const TrackedObject& landmark,
                                    const NavVector& x) const;
  /// True if the object may be a landmark that drift could have put elsewhere: then it is mapped in
  /// doubt, and decided with what is seen beside it.
  [[nodiscard]] bool ShouldWait(TrackedObject& object, const TrackerFrame& frame);
  /// Where the pose is sure: recognises, adopts as new, or adopts in doubt.
  void Settle(TrackedObject& object, const TrackerFrame& frame);
  [[nodiscard]] bool IsPlaced(const TrackedObject& object) const {
    return object.covariance.diagonal().maxCoeff() <= params_.confirm_sd_m * params_.confirm_sd_m;
  }
  [[nodiscard]] std::vector<TrackedObject*> LandmarksNear(const Eigen::Vector3d& p);
  void Adopt(TrackedObject& object, bool is_in_doubt);
  /// Gives the looks of a tentative object to a landmark.
  void Recognise(TrackedObject& landmark, TrackedObject& tentative);
  void AddTerms(TrackedObject& object, Look& look, bool with_seabed);
  void DropStale(double now);
  bool RemoveOutliers();
  /// Looks that do not fit a landmark but agree among themselves are another object after all.
  void SplitOff(std::vector<Look> looks, const TrackedObject& from,
                std::vector<TrackedObject>& split);
  /// Doubts landmarks that are likely to be one.
  void SuspectDuplicates();
  /// -2 ln of how many more objects there are per m^3 around a known one: where objects come in
  /// pairs, another one beside a known one is no surprise.
  [[nodiscard]] double NewCost() const;
  struct Company {
    double density = 0.0;  ///< of objects beside one that has none there yet [1/m^3]
    double crowd = 0.0;    ///< share of it beside one that has
  };
  [[nodiscard]] Company CompanyOf() const;
  /// Landmarks near it.
  [[nodiscard]] int CountBeside(const TrackedObject& object) const;
  struct Identities;
  /// True if what it is may be decided: it has been seen enough, or is out of view.
  [[nodiscard]] bool IsDecidable(const TrackedObject& object, bool is_last) const;
  /// So that a decision stays cheap: the surest of what is open is closed, the oldest doubt is
  /// given up. True if the graph changed.
  bool LimitOpen();
  [[nodiscard]] Identities CollectIdentities(bool is_last);
  /// What each of the first so many may be.
  void AddClaimants(Identities& all, int claimants) const;
  /// Decides together which landmarks are others seen again, as far as that is clear, and takes
  /// back what no longer is. True if the graph changed.
  bool Reconsider(bool is_last);
  bool Decide(const Identities& all, bool is_last);
  void NoteProvisional();
  void Tie(TrackedObject& object, TrackedObject& to);
  void Release(TrackedObject& object);
  void ReleaseTiedTo(const TrackedObject& object);
  /// Makes tied objects one for good.
  bool AbsorbSure(const Identities& all);
  void Absorb(TrackedObject& object);
  bool ForgetEmptySlots();
  [[nodiscard]] TrackedObject* ById(int id);
  /// Place of a tentative object from its looks; a look that cannot be of it goes.
  void Retriangulate(TrackedObject& object);
  void Locate(TrackedObject& object);

  Smoother& smoother_;
  const CameraModel& camera_;
  ObjectTrackerParams params_;
  std::vector<TrackedObject> objects_;
  int next_id_ = 1;
  int rejected_looks_ = 0;
  double now_ = 0.0;
  std::vector<int> empty_slots_;  ///< absorbed, to be removed when the smoother has caught up
  /// True while a landmark is tied to another one that it may not be: then the pose is not as sure
  /// as it seems, and what is seen again is mapped in doubt.
  bool is_provisional_ = false;
  int identity_news_ = 0;  ///< since identities were last considered
  double considered_t_ = -1e18;
  int considered_count_ = 0;
};

}  // namespace limpet
