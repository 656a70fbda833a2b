// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "estimation/change/contrast_log.hpp"
#include "estimation/change/place_watch.hpp"
#include "estimation/change/status.hpp"
#include "estimation/change/tentative_objects.hpp"
#include "limpet/objects/former_session.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

struct StatusParams {
  DetectionModel detection;
  LookParams looks;
  StatusPriors priors;
  MatchingParams matching;         ///< of these only what is needed where matches are given
  double visibility_spread = 2.0;  ///< factor that is one standard deviation of what was expected
  Meters object_radius{0.5};
  Meters merge_within{1.2};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    detection.Describe(visit);
    looks.Describe(visit);
    priors.Describe(visit);
    matching.DescribeForGivenMatches(visit);
    visit("visibility_spread", visibility_spread,
          "The water's visibility may well be visibility_m times or by this factor",
          InRange(1.05, 10.0));
    visit.Required("object_radius_m", object_radius, "Radius of the objects looked for",
                   InRange(0.05_m, 5.0_m));
    visit("merge_within_m", merge_within,
          "Landmarks closer than this and never seen together are one object",
          InRange(0.0_m, 10.0_m));
  }
  /// What judges a look of `camera` at an object of the usual size.
  [[nodiscard]] LookModel LookFrom(const CameraModel& camera) const {
    return {.camera = camera, .detection = detection, .object_radius = object_radius.value()};
  }
};

/// Where the former session looked from, in its frame and in order of time, with what it saw there
/// and how well it saw.
struct FormerViews {
  std::vector<ObservedFrame> frames;  ///< boxes of the listed objects may be left out
  WatchModel model;                   ///< its visibility is not asked: `water` is
  LookParams looks;
  VisibilityBelief water{DetectionModel().visibility, StatusParams().visibility_spread};
};

/// Everything one session knows about the status of objects: frames and landmarks in, posteriors
/// out. Keeps all frames, because a landmark is confirmed only some frames after it was first seen.
class ObjectStatuses {
 public:
  ObjectStatuses(const StatusParams& params, const CameraModel& camera);

  /// Makes this a change session. Call before the first frame, or lose nothing: frames are
  /// replayed.
  void SetFormer(std::vector<FormerObject> former);
  /// What the former session would have seen at places where it lists nothing. A session whose
  /// views are not known has looked nowhere: it proves nothing about such a place.
  void SetFormerViews(FormerViews views);
  /// What stands between the camera and a place has it not looked at. Counts for frames that come;
  /// for former ones with the next Rejudge.
  void SetObstacles(const std::vector<Obstacle>& obstacles) {
    model_.obstacles = SightObstacles(obstacles);
  }
  /// Frames in order of time.
  void AddFrame(ObservedFrame frame);
  /// Takes kept frames along when the track behind the vehicle has moved; `moved` gives the new
  /// pose from time [s] and old pose. Landmarks that moved with it are to follow.
  void MoveFrames(const std::function<Pose(double t, const Pose& X_WB)>& moved);
  /// All landmarks as now estimated; one that is absent is forgotten. Which
  /// former object each of them is, if any, is taken as they say it.
  void SetLandmarks(const std::vector<Landmark>& landmarks);
  /// Judges every place again from all frames, exactly where it now is, with the rate of false
  /// boxes that these frames show. After this what is believed depends on the frames, the
  /// landmarks, the obstacles and the former session alone, not on how they came.
  void Rejudge();

  /// All objects, former ones first, then by id. What is certainly nothing is left out.
  [[nodiscard]] std::vector<OpiBelief> Assess();
  [[nodiscard]] const FrameOffset& offset() const { return match_.offset; }
  [[nodiscard]] const std::vector<ObservedFrame>& frames() const { return frames_; }
  /// Boxes per image that show nothing: what the mission says, weighed with what was seen.
  [[nodiscard]] double false_per_image() const { return model_.look.detection.false_per_image; }
  /// What images say of the water, beside the objects in them.
  [[nodiscard]] ContrastLog& contrasts() { return contrasts_; }
  [[nodiscard]] const ContrastLog& contrasts() const { return contrasts_; }
  /// How far one can see, from the contrasts and from how far objects of known places were and were
  /// not seen; from nothing else, so it depends on what is kept alone.
  [[nodiscard]] VisibilityBelief Water() const;
  /// Places that boxes hint at but that nobody is sent to, because there were too many.
  [[nodiscard]] int tentative_left_out() const { return tentative_.left_out(); }
  /// Landmarks that were often detected and are believed to be none: their boxes do not look as
  /// such an object would.
  [[nodiscard]] int landmarks_doubted() const { return landmarks_doubted_; }
  /// The landmark that stands for `landmark` after merging; nothing if it is not
  /// confirmed.
  [[nodiscard]] std::optional<int> Representative(const std::optional<int>& landmark) const;
  /// The box of an object in a frame, also in one from before the smoother knew the object.
  /// nullptr if the frame has none, or the object is no landmark.
  [[nodiscard]] const Box* BoxOf(const OpiBelief& object, const ObservedFrame& frame) const;

 private:
  void Replay(PlaceWatch& watch, const OwnerOf& owner_of) const;
  [[nodiscard]] OwnerOf OwnerForLandmark(int landmark) const;
  [[nodiscard]] OwnerOf OwnerForFormer() const;
  [[nodiscard]] bool IsExplained(const ObservedFrame& frame, const Box& box) const;
  [[nodiscard]] double FalseRate() const;
  void MergeLandmarks();
  [[nodiscard]] bool AreOne(const Landmark& a, const Landmark& b) const;
  void WatchLandmarks();
  void WatchFormer(bool rejudges_all);
  /// What the former session saw of a newcomer's place.
  [[nodiscard]] const PlaceWatch& FormerWatchAt(const Landmark& newcomer);
  /// Lambda of that, as the former session's water is believed to be.
  [[nodiscard]] double FormerLambdaAt(const Landmark& newcomer);
  /// The former session's water: what it found out itself, and what of the newcomers it may have
  /// missed.
  [[nodiscard]] VisibilityBelief FormerWater();
  [[nodiscard]] OwnerOf OwnerInFormerViews() const;
  /// The place where the other session's frame has it, with what is then unknown about it.
  [[nodiscard]] ObjectEstimate InOtherFrame(ObjectEstimate place, const Eigen::Vector3d& p_W) const;
  [[nodiscard]] ObjectEstimate FormerPlace(std::size_t index) const;
  /// Takes the matches from the landmarks, and fits the frames' offset to them.
  void TakeMatches();
  void TakeCandidates(const Landmark& landmark, std::size_t object);
  /// Chance that one of the objects is the former one.
  [[nodiscard]] double ChanceOfFormer(std::size_t index) const;
  [[nodiscard]] StatusPosterior PosteriorOfFormer(std::size_t index) const;
  [[nodiscard]] StatusPosterior PosteriorOfNewcomer(std::size_t index);
  /// Lambda of a place, as the water is believed to be.
  [[nodiscard]] double LambdaOf(const PlaceWatch& watch) const;
  /// Looks at a place, as the water is believed to be.
  [[nodiscard]] int Looks(const PlaceWatch& watch) const;
  [[nodiscard]] int IdOfLandmark(int landmark);
  [[nodiscard]] OpiBelief StatusOfFormer(std::size_t index) const;
  [[nodiscard]] std::optional<OpiBelief> StatusOfNewcomer(std::size_t index);
  /// A place that hints at an object, as one of which nothing is known; nothing if another entry
  /// tells about it.
  [[nodiscard]] std::optional<OpiBelief> StatusOfTentative(TentativeObject& tentative);
  /// Tells what is gone and what came beside it as one object that has moved, the likeliest pairs
  /// first.
  void PairMoved(std::vector<OpiBelief>& objects) const;
  [[nodiscard]] int CountDoubted(const std::vector<OpiBelief>& objects) const;

  StatusParams params_;
  WatchModel model_;
  ContrastLog contrasts_;
  VisibilityBelief water_;  ///< when objects were last assessed
  std::vector<ObservedFrame> frames_;
  std::optional<std::vector<FormerObject>> former_;
  FormerViews former_views_;
  VisibilityBelief former_water_;      ///< the former session's, when objects were last assessed
  std::vector<Landmark> landmarks_;    ///< as given
  std::vector<Landmark> objects_;      ///< merged: one per object, by id
  std::map<int, int> representative_;  ///< landmark to the one that stands for it
  std::set<std::pair<int, int>> seen_together_;
  std::map<int, PlaceWatch> landmark_watch_;
  std::vector<std::optional<PlaceWatch>> former_watch_;
  bool rejudges_all_ = false;  ///< frames have moved since landmarks were last set
  SessionMatch match_;  ///< of objects_; `chance` is what landmarks say, 1 for a decided match
  std::map<int, PlaceWatch> newcomer_watch_;  ///< former views of newcomers' places, by landmark
  TentativeObjects tentative_;
  int landmarks_doubted_ = 0;
  std::map<int, int> id_of_landmark_;
  int next_id_ = 1;
};

}  // namespace limpet
