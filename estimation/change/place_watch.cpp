// SPDX-License-Identifier: MIT
#include "estimation/change/place_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limpet {
namespace {

constexpr double kPixelSigma = 6.0;  ///< of a box's centre
constexpr double kSizeShare = 0.15;  ///< and as a share of the object's size in pixels
constexpr double kGateSigmas = 3.0;
constexpr double kLeastFalseAlarm = 1e-4;
constexpr double kLargestFalseAlarm = 0.2;

/// How a frame sees an uncertain place.
struct Prospect {
  double detects = 0.0;  ///< chance of a box if an object is there
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double gate = 0.0;  ///< radius around `pixel` in which its box would be [px]
};

/// Averages over the place's horizontal uncertainty: mean and one sigma to each side.
double AverageDetection(const PlacedObject& place, const Pose& X_WB, const WatchModel& model) {
  const double north = std::sqrt(std::max(place.cov(0, 0), 0.0));
  const double east = std::sqrt(std::max(place.cov(1, 1), 0.0));
  const std::array<Eigen::Vector3d, 5> offsets{
      Eigen::Vector3d::Zero(), Eigen::Vector3d(north, 0, 0), Eigen::Vector3d(-north, 0, 0),
      Eigen::Vector3d(0, east, 0), Eigen::Vector3d(0, -east, 0)};
  double sum = 0.0;
  for (const Eigen::Vector3d& offset : offsets) {
    const Eigen::Vector3d p_W = place.ned + offset;
    const double share = VisibleShare(model.camera, X_WB, p_W, model.object_radius);
    sum += share > 0.0 ? model.detection.Detects((p_W - X_WB.p_WB).norm(), share) : 0.0;
  }
  return sum / static_cast<double>(offsets.size());
}

std::optional<Prospect> Foresee(const PlacedObject& place, const Pose& X_WB,
                                const WatchModel& model) {
  const Eigen::Vector3d p_C = model.camera.InCamera(X_WB, place.ned);
  const std::optional<Eigen::Vector2d> pixel = model.camera.Project(p_C);
  // Far outside the image nothing needs to be computed; most frames end here.
  if (!pixel || std::abs(pixel->x() - model.camera.cx()) > 2.0 * model.camera.width_px ||
      std::abs(pixel->y() - model.camera.cy()) > 2.0 * model.camera.height_px) {
    return std::nullopt;
  }
  const double pixels_per_metre = model.camera.fx() / p_C.z();
  const double position = std::sqrt(std::max(0.5 * (place.cov(0, 0) + place.cov(1, 1)), 0.0));
  const double sigma = std::hypot(
      kPixelSigma, std::hypot(position, 2.0 * kSizeShare * model.object_radius) * pixels_per_metre);
  return Prospect{.detects = AverageDetection(place, X_WB, model),
                  .pixel = *pixel,
                  .gate = kGateSigmas * sigma};
}

/// An object cut by the image's border has its box's centre farther inside than its own.
Eigen::Vector2d ClampToImage(const Eigen::Vector2d& pixel, const CameraGeometry& camera) {
  return {std::clamp(pixel.x(), 0.0, static_cast<double>(camera.width_px)),
          std::clamp(pixel.y(), 0.0, static_cast<double>(camera.height_px))};
}

bool HasBox(const SightRecord& sight, const Prospect& prospect, const CameraGeometry& camera,
            const OwnerOf& owner_of) {
  return std::ranges::any_of(sight.boxes, [&](const SightedDetection& box) {
    const BoxOwner owner = owner_of(box);
    const Eigen::Vector2d centre(box.u, box.v);
    return owner == BoxOwner::kThisPlace ||
           (owner == BoxOwner::kUnknown &&
            (centre - ClampToImage(prospect.pixel, camera)).norm() <= prospect.gate);
  });
}

double FalseAlarm(const Prospect& prospect, const WatchModel& model) {
  const double gate_area = std::numbers::pi * prospect.gate * prospect.gate;
  const double image_area = static_cast<double>(model.camera.width_px) * model.camera.height_px;
  return std::clamp(model.detection.false_per_image * std::min(gate_area / image_area, 1.0),
                    kLeastFalseAlarm, kLargestFalseAlarm);
}

}  // namespace

void PlaceWatch::See(const SightRecord& sight, const WatchModel& model, const OwnerOf& owner_of) {
  const std::optional<Prospect> prospect = Foresee(place_, sight.X_WB, model);
  if (!prospect) {
    return;
  }
  const bool has_box = HasBox(sight, *prospect, model.camera, owner_of);
  if (prospect->detects < model.least_detection && !has_box) {
    return;
  }
  log_.Add({.time = sight.time,
            .p_OC = sight.X_WB.p_WB - place_.ned,
            .detects = std::max(prospect->detects, model.least_detection),
            .false_alarm = FalseAlarm(*prospect, model),
            .has_box = has_box});
}

}  // namespace limpet
