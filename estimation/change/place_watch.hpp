// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "estimation/change/look_log.hpp"
#include "estimation/matching/session_matching.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/survey/sight_obstacles.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// What it takes to judge a place in a frame.
struct WatchModel {
  LookModel look;                ///< its radius is of an object whose size nobody has estimated
  double least_detection = 0.2;  ///< frames with less chance of a box say nothing
  /// Visibilities that the water may have [m]; nothing: it has the one of `look`.
  std::optional<PerVisibility> visibilities = std::nullopt;
  SightObstacles obstacles{};  ///< that the camera does not see through
};

/// Where in a frame the object of an uncertain place is expected to appear.
struct Foresight {
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< of the object's image [px]
  double gate = 0.0;    ///< how far from `at_px` its box would be centred [px]
  /// By what share its image may be larger or smaller, for what is unknown of the object's size.
  double size_slack = 1.0;
  /// True if the box could be that of an object here.
  [[nodiscard]] bool Explains(const Box& box, const CameraModel& camera) const;
};
/// Nothing for a place that is far outside the image.
[[nodiscard]] std::optional<Foresight> Foresee(const ObjectEstimate& place, const Pose& X_WB,
                                               const WatchModel& model);

/// Whose box a detection is, seen from one place.
enum class BoxOwner { kThisPlace, kAnotherPlace, kUnknown };
using OwnerOf = std::function<BoxOwner(const ObservedFrame&, const Box&)>;

/// The box in a frame that shows an object at `place`: one of its own, else one of unknown owner
/// that falls near the place's projection and has its colour and size. nullptr if there is none.
[[nodiscard]] const Box* FindBox(const ObservedFrame& frame, const ObjectEstimate& place,
                                 const WatchModel& model, const OwnerOf& owner_of);

/// A place where an object is or may be, and what this session's frames said about it. Boxes of
/// unknown owner count when they fall near the place's projection and have its colour and size; the
/// false-alarm rate is that of so large a part of the image.
///
/// Where exactly the object would be is uncertain, and the same for all frames: a pass that looks
/// beside it misses it in every frame. So each of a few possible spots keeps a log of its own, and
/// their likelihoods are averaged.
class PlaceWatch {
 public:
  PlaceWatch(const ObjectEstimate& place, const LookParams& looks);

  /// Judges one frame; frames in order of time.
  void See(const ObservedFrame& frame, const WatchModel& model, const OwnerOf& owner_of);
  /// What the looks say so far, for each visibility of the WatchModel, as all that follows.
  [[nodiscard]] PlaceEvidence evidence() const;
  /// The chance that an object is here, and what each look counts: they share water, light and
  /// pose.
  struct Supposed {
    double chance = 0.5, look_worth = 1.0;
  };
  /// ln P of what was seen here.
  [[nodiscard]] PerVisibility LogLikelihood(const Supposed& supposed) const;
  /// Looks at the most likely spot.
  [[nodiscard]] PerVisibility looks() const { return spots_.front().log.looks(); }
  [[nodiscard]] int looks_with_box() const { return spots_.front().log.looks_with_box(); }
  [[nodiscard]] const ObjectEstimate& place() const { return place_; }

 private:
  struct Spot {
    Eigen::Vector3d p_W;
    double weight;
    LookLog log;
  };
  ObjectEstimate place_;
  std::vector<Spot> spots_;
};

}  // namespace limpet
