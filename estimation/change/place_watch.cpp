// SPDX-License-Identifier: MIT
#include "estimation/change/place_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimation/change/log_space.hpp"

namespace limpet {
namespace {

constexpr double kPixelSigma = 6.0;  ///< of a box's centre
constexpr double kSizeShare = 0.15;  ///< and as a share of the object's size in pixels
constexpr double kGateSigmas = 3.0;
constexpr double kLeastFalseAlarm = 2e-5;
constexpr double kLargestFalseAlarm = 0.2;

// A false box has any colour and any size; one that could be this object is rarer.
// Not what two painted objects have in common, which moves are weighed by: a detector's mistake is
// of any of the colours that it knows.
constexpr double kFalseBoxHasColor = 0.25;
constexpr double kSameSize = 0.4;
constexpr double kSmallestSize = 0.6;  ///< of the expected, for a box that the border leaves whole
constexpr double kLargestSize = 1.6;
constexpr double kSizeSigmas = 2.0;  ///< of the object's own size that these shares allow for
constexpr double kMostSlack = 2.5;   ///< a size that is known no better tells nothing

LookModel LookModelOf(const WatchModel& model, const ObjectEstimate& place) {
  LookModel look = model.look;
  look.object_radius = place.RadiusOr(look.object_radius);
  return look;
}

double SizeSlackOf(const ObjectEstimate& place) {
  if (!place.is_size_known()) return 1.0;
  const double sd = std::max(place.size->sd, 0.0) / place.size->radius;
  return std::min(std::exp(kSizeSigmas * sd), kMostSlack);
}

/// A box of the object's colour and size.
bool LooksLike(const Box& box, const ObjectEstimate& place, const Foresight& foresight,
               const CameraModel& camera) {
  const double diameter_px = 2.0 * foresight.radius;
  const double largest = kLargestSize * foresight.size_slack * diameter_px;
  const double smallest = kSmallestSize / foresight.size_slack * diameter_px;
  const bool is_small_enough = std::max(box.w, box.h) <= largest;
  const bool is_large_enough = IsCut(box, camera) || std::min(box.w, box.h) >= smallest;
  return is_small_enough && is_large_enough && (place.color.empty() || box.color == place.color);
}

/// What a frame's boxes say about the place: one of its own, or one that may be.
struct BoxesHere {
  const Box* own = nullptr;
  const Box* possible = nullptr;
};

BoxesHere LookForBoxes(const ObservedFrame& frame, const ObjectEstimate& place,
                       const Foresight& foresight, const CameraModel& camera,
                       const OwnerOf& owner_of) {
  BoxesHere here;
  for (const Box& box : frame.boxes) {
    const BoxOwner owner = owner_of(frame, box);
    if (owner == BoxOwner::kThisPlace) {
      here.own = &box;
    } else if (owner == BoxOwner::kUnknown && foresight.Explains(box, camera) &&
               LooksLike(box, place, foresight, camera)) {
      here.possible = &box;
    }
  }
  return here;
}

double FalseAlarm(const Foresight& foresight, const WatchModel& model) {
  const double gate_area = std::numbers::pi * foresight.gate * foresight.gate;
  const double image_area =
      static_cast<double>(model.look.camera.width_px) * model.look.camera.height_px;
  const double wider =
      1.0 + 2.0 * std::log(foresight.size_slack) / std::log(kLargestSize / kSmallestSize);
  const double same_size = std::min(kSameSize * wider, 1.0);
  const double rate = kFalseBoxHasColor * same_size * model.look.detection.false_per_image;
  return std::clamp(rate * std::min(gate_area / image_area, 1.0), kLeastFalseAlarm,
                    kLargestFalseAlarm);
}

}  // namespace

bool Foresight::Explains(const Box& box, const CameraModel& camera) const {
  // An object cut by the image's border has its box's centre farther inside than its own, by at
  // most its radius.
  const Eigen::Vector2d centre(box.u, box.v);
  const Eigen::Vector2d inside(std::clamp(at_px.x(), 0.0, static_cast<double>(camera.width_px)),
                               std::clamp(at_px.y(), 0.0, static_cast<double>(camera.height_px)));
  return (centre - inside).norm() <= gate && (centre - at_px).norm() <= gate + radius;
}

std::optional<Foresight> Foresee(const ObjectEstimate& place, const Pose& X_WB,
                                 const WatchModel& model) {
  const Eigen::Vector3d p_C = model.look.camera.InCamera(X_WB, place.p_W);
  const std::optional<Eigen::Vector2d> pixel = model.look.camera.Project(p_C);
  // Far outside the image nothing needs to be computed; most frames end here.
  if (!pixel || std::abs(pixel->x() - model.look.camera.cx) > 2.0 * model.look.camera.width_px ||
      std::abs(pixel->y() - model.look.camera.cy) > 2.0 * model.look.camera.height_px) {
    return std::nullopt;
  }
  const double pixels_per_metre = model.look.camera.fx / p_C.z();
  const double position = std::sqrt(std::max(0.5 * (place.cov_W(0, 0) + place.cov_W(1, 1)), 0.0));
  const double radius = place.RadiusOr(model.look.object_radius);
  const double size = 2.0 * kSizeShare * radius;
  const double sigma = std::hypot(kPixelSigma, std::hypot(position, size) * pixels_per_metre);
  return Foresight{.at_px = *pixel,
                   .radius = radius * pixels_per_metre,
                   .gate = kGateSigmas * sigma,
                   .size_slack = SizeSlackOf(place)};
}

const Box* FindBox(const ObservedFrame& frame, const ObjectEstimate& place, const WatchModel& model,
                   const OwnerOf& owner_of) {
  const std::optional<Foresight> foresight = Foresee(place, frame.X_WB, model);
  if (!foresight) {
    return nullptr;
  }
  const BoxesHere boxes = LookForBoxes(frame, place, *foresight, model.look.camera, owner_of);
  return boxes.own != nullptr ? boxes.own : boxes.possible;
}

PlaceWatch::PlaceWatch(const ObjectEstimate& place, const LookParams& looks) : place_(place) {
  // Unscented points of the horizontal position: their mean and covariance are the place's.
  const double north = std::sqrt(3.0 * std::max(place.cov_W(0, 0), 0.0));
  const double east = std::sqrt(3.0 * std::max(place.cov_W(1, 1), 0.0));
  const LookLog empty(looks);
  spots_ = {{place.p_W, 1.0 / 3.0, empty},
            {place.p_W + Eigen::Vector3d(north, 0, 0), 1.0 / 6.0, empty},
            {place.p_W - Eigen::Vector3d(north, 0, 0), 1.0 / 6.0, empty},
            {place.p_W + Eigen::Vector3d(0, east, 0), 1.0 / 6.0, empty},
            {place.p_W - Eigen::Vector3d(0, east, 0), 1.0 / 6.0, empty}};
}

void PlaceWatch::See(const ObservedFrame& frame, const WatchModel& model, const OwnerOf& owner_of) {
  const std::optional<Foresight> foresight = Foresee(place_, frame.X_WB, model);
  if (!foresight) {
    return;
  }
  const BoxesHere boxes = LookForBoxes(frame, place_, *foresight, model.look.camera, owner_of);
  const bool has_own = boxes.own != nullptr;
  const double false_alarm = FalseAlarm(*foresight, model);
  const LookModel look = LookModelOf(model, place_);
  const PerVisibility visibilities =
      model.visibilities.value_or(model.look.detection.visibility.value());
  for (Spot& spot : spots_) {
    const PerVisibility detects = ChancesToDetect(look, frame.X_WB, spot.p_W, visibilities);
    if (detects.maxCoeff() < model.least_detection && !has_own) continue;
    if (!has_own && model.obstacles.Hide(EyeOf(model.look.camera, frame.X_WB), spot.p_W)) continue;
    spot.log.Add({.time = frame.exposure.value(),
                  .p_OC = frame.X_WB.p_WB - spot.p_W,
                  .detects = has_own ? PerVisibility(detects.max(model.least_detection)) : detects,
                  .false_alarm = false_alarm,
                  .has_box = has_own || boxes.possible != nullptr});
  }
}

PlaceEvidence PlaceWatch::evidence() const {
  const auto weighed = [](const Spot& spot) {
    const PlaceEvidence here = spot.log.evidence();
    const double weight = std::log(spot.weight);
    return PlaceEvidence{.present = weight + here.present, .lookalike = weight + here.lookalike};
  };
  PlaceEvidence sum = weighed(spots_.front());
  for (std::size_t i = 1; i < spots_.size(); ++i) {
    const PlaceEvidence here = weighed(spots_[i]);
    sum.present = LogSum(sum.present, here.present);
    sum.lookalike = LogSum(sum.lookalike, here.lookalike);
  }
  return sum;
}

PerVisibility PlaceWatch::LogLikelihood(const Supposed& supposed) const {
  const LookLog::Likelihoods seen = spots_.front().log.likelihoods();
  const auto [chance, worth] = supposed;
  return LogSum(std::log(chance) + worth * seen.present, std::log1p(-chance) + worth * seen.bare);
}

}  // namespace limpet
