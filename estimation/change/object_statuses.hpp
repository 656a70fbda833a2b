// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/change/contrast_log.hpp"
#include "estimation/change/former_sight.hpp"
#include "estimation/change/former_ties.hpp"
#include "estimation/change/merged_landmarks.hpp"
#include "estimation/change/object_ids.hpp"
#include "estimation/change/place_watches.hpp"
#include "estimation/change/status.hpp"
#include "estimation/change/status_params.hpp"
#include "estimation/change/tentative_objects.hpp"
#include "limpet/objects/former_session.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// Everything one session knows about the status of objects: frames and landmarks in, posteriors
/// out.
class ObjectStatuses {
 public:
  ObjectStatuses(const StatusParams& params, const CameraModel& camera);

  /// Makes this a change session. Call before the first frame, or lose nothing: frames are
  /// replayed.
  void SetFormer(std::vector<FormerObject> former);
  /// What the former session would have seen at places where it lists nothing. A session whose
  /// views are not known has looked nowhere: it proves nothing about such a place.
  void SetFormerViews(FormerViews views) { former_sight_.SetViews(std::move(views)); }
  /// What stands between the camera and a place has it not looked at. Counts for frames that come;
  /// for former ones with the next Rejudge.
  void SetObstacles(const std::vector<Obstacle>& obstacles) {
    watches_.SetObstacles(SightObstacles(obstacles));
  }
  /// Frames in order of time.
  void AddFrame(ObservedFrame frame);
  /// Takes kept frames along when the track behind the vehicle has moved; `moved` gives the new
  /// pose from time [s] and old pose. Landmarks that moved with it are to follow.
  void MoveFrames(const std::function<Pose(double t, const Pose& X_WB)>& moved) {
    watches_.Move(moved);
  }
  /// All landmarks as now estimated; one that is absent is forgotten. Which former object each of
  /// them is, if any, is taken as they say it.
  void SetLandmarks(const std::vector<Landmark>& landmarks);
  /// Judges every place again from all frames, exactly where it now is, with the rate of false
  /// boxes that these frames show. After this what is believed depends on the frames, the
  /// landmarks, the obstacles and the former session alone, not on how they came.
  void Rejudge();

  /// All objects, former ones first, then by id. What is certainly nothing is left out.
  [[nodiscard]] std::vector<OpiBelief> Assess();
  /// Offset of the former session's frame in this one's; none without a former session.
  [[nodiscard]] FrameOffset offset() const { return ties_ ? ties_->offset() : FrameOffset{}; }
  [[nodiscard]] const std::vector<ObservedFrame>& frames() const { return watches_.frames(); }
  /// Boxes per image that show nothing: what the mission says, weighed with what was seen.
  [[nodiscard]] double false_per_image() const {
    return watches_.model().look.detection.false_per_image;
  }
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
  [[nodiscard]] std::optional<int> Representative(const std::optional<int>& landmark) const {
    return landmarks_.Representative(landmark);
  }
  /// The box of an object in a frame, also in one from before the smoother knew the object.
  /// nullptr if the frame has none, or the object is no landmark.
  [[nodiscard]] const Box* BoxOf(const OpiBelief& object, const ObservedFrame& frame) const;

 private:
  [[nodiscard]] double FalseRate() const;
  void Watch(bool are_owners_new);
  [[nodiscard]] const PlaceWatch& WatchOf(std::size_t object) const {
    return watches_.OfLandmark(landmarks_.objects()[object].id);
  }
  [[nodiscard]] StatusPosterior PosteriorOfFormer(std::size_t former) const;
  [[nodiscard]] StatusPosterior PosteriorOfNewcomer(std::size_t object);
  /// Lambda of the former session for a place that it does not list, as its water is believed to
  /// be.
  [[nodiscard]] double FormerLambdaAt(const Landmark& newcomer);
  /// A belief with what was seen of its place, as the water is believed to be.
  [[nodiscard]] OpiBelief BeliefFrom(const PlaceWatch& watch) const;
  [[nodiscard]] OpiBelief StatusOfFormer(std::size_t former) const;
  [[nodiscard]] std::optional<OpiBelief> StatusOfNewcomer(std::size_t object);
  /// A place that hints at an object, as one of which nothing is known; nothing if another entry
  /// tells about it.
  [[nodiscard]] std::optional<OpiBelief> StatusOfTentative(TentativeObject& tentative);
  [[nodiscard]] bool IsToldOf(const ObjectEstimate& place) const;

  StatusParams params_;
  MergedLandmarks landmarks_;
  PlaceWatches watches_;
  ContrastLog contrasts_;
  VisibilityBelief water_;          ///< when objects were last assessed
  std::optional<FormerTies> ties_;  ///< of a change session
  FormerSight former_sight_;
  VisibilityBelief former_water_;  ///< the former session's, when objects were last assessed
  TentativeObjects tentative_;
  ObjectIds ids_;
  int landmarks_doubted_ = 0;
};

}  // namespace limpet
