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
constexpr double kSpotShare = 0.6;  ///< of the place's deviation that a spot stands for
constexpr double kLeastFalseAlarm = 2e-5;
constexpr double kLargestFalseAlarm = 0.2;

// A false box has any colour and any size; one that could be this object is rarer.
constexpr double kSameColor = 0.25;
constexpr double kSameSize = 0.4;
constexpr double kSmallestSize =
    0.6;  ///< of the expected size, for a box that the border leaves whole
constexpr double kLargestSize = 1.6;
constexpr double kBorder = 3.0;  ///< a box this near the image's border is cut [px]

/// Where an object would lie in a frame.
struct Prospect {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double gate = 0.0;  ///< radius around `pixel` in which its box would be [px]
  double size = 0.0;  ///< of its box [px]
};

std::optional<Prospect> Foresee(const Eigen::Vector3d& p_W, double deviation, const Pose& X_WB,
                                const WatchModel& model) {
  const Eigen::Vector3d p_C = model.camera.InCamera(X_WB, p_W);
  const std::optional<Eigen::Vector2d> pixel = model.camera.Project(p_C);
  // Far outside the image nothing needs to be computed; most frames end here.
  if (!pixel || std::abs(pixel->x() - model.camera.cx()) > 2.0 * model.camera.width_px ||
      std::abs(pixel->y() - model.camera.cy()) > 2.0 * model.camera.height_px) {
    return std::nullopt;
  }
  const double pixels_per_metre = model.camera.fx() / p_C.z();
  const double size = 2.0 * model.object_radius * pixels_per_metre;
  const double sigma =
      std::hypot(kPixelSigma, std::hypot(deviation * pixels_per_metre, kSizeShare * size));
  return Prospect{.pixel = *pixel, .gate = kGateSigmas * sigma, .size = size};
}

double Detects(const Eigen::Vector3d& p_W, const Pose& X_WB, const WatchModel& model) {
  const double share = VisibleShare(model.camera, X_WB, p_W, model.object_radius);
  return share > 0.0 ? model.detection.Detects((p_W - X_WB.p_WB).norm(), share) : 0.0;
}

/// An object cut by the image's border has its box's centre farther inside than its own.
Eigen::Vector2d ClampToImage(const Eigen::Vector2d& pixel, const CameraGeometry& camera) {
  return {std::clamp(pixel.x(), 0.0, static_cast<double>(camera.width_px)),
          std::clamp(pixel.y(), 0.0, static_cast<double>(camera.height_px))};
}

bool IsCut(const SightedDetection& box, const CameraGeometry& camera) {
  return box.u - 0.5 * box.w < kBorder || box.u + 0.5 * box.w > camera.width_px - kBorder ||
         box.v - 0.5 * box.h < kBorder || box.v + 0.5 * box.h > camera.height_px - kBorder;
}

/// A box that could be the object of this place: near where it would be, of its colour and size.
bool Fits(const SightedDetection& box, const Prospect& prospect, const std::string& color,
          const CameraGeometry& camera) {
  const Eigen::Vector2d centre(box.u, box.v);
  const double smaller = std::min(box.w, box.h);
  const double larger = std::max(box.w, box.h);
  const bool has_size = larger <= kLargestSize * prospect.size &&
                        (IsCut(box, camera) || smaller >= kSmallestSize * prospect.size);
  const bool has_color = color.empty() || box.color == color;
  return has_size && has_color &&
         (centre - ClampToImage(prospect.pixel, camera)).norm() <= prospect.gate;
}

bool HasBox(const SightRecord& sight, const Prospect& prospect, const std::string& color,
            const CameraGeometry& camera, const OwnerOf& owner_of) {
  return std::ranges::any_of(sight.boxes, [&](const SightedDetection& box) {
    const BoxOwner owner = owner_of(box);
    return owner == BoxOwner::kThisPlace ||
           (owner == BoxOwner::kUnknown && Fits(box, prospect, color, camera));
  });
}

double FalseAlarm(const Prospect& prospect, const WatchModel& model) {
  const double gate_area = std::numbers::pi * prospect.gate * prospect.gate;
  const double image_area = static_cast<double>(model.camera.width_px) * model.camera.height_px;
  const double rate = kSameColor * kSameSize * model.detection.false_per_image;
  return std::clamp(rate * std::min(gate_area / image_area, 1.0), kLeastFalseAlarm,
                    kLargestFalseAlarm);
}

}  // namespace

PlaceWatch::PlaceWatch(const PlacedObject& place, const LookParams& looks) : place_(place) {
  // Unscented points of the horizontal position: their mean and covariance are the place's.
  const double north = std::sqrt(3.0 * std::max(place.cov(0, 0), 0.0));
  const double east = std::sqrt(3.0 * std::max(place.cov(1, 1), 0.0));
  const LookLog empty(looks);
  spots_ = {{place.ned, 1.0 / 3.0, empty},
            {place.ned + Eigen::Vector3d(north, 0, 0), 1.0 / 6.0, empty},
            {place.ned - Eigen::Vector3d(north, 0, 0), 1.0 / 6.0, empty},
            {place.ned + Eigen::Vector3d(0, east, 0), 1.0 / 6.0, empty},
            {place.ned - Eigen::Vector3d(0, east, 0), 1.0 / 6.0, empty}};
}

void PlaceWatch::See(const SightRecord& sight, const WatchModel& model, const OwnerOf& owner_of) {
  const double deviation =
      kSpotShare * std::sqrt(std::max(0.5 * (place_.cov(0, 0) + place_.cov(1, 1)), 0.0));
  for (Spot& spot : spots_) {
    const std::optional<Prospect> prospect = Foresee(spot.p_W, deviation, sight.X_WB, model);
    if (!prospect) continue;
    const bool has_box = HasBox(sight, *prospect, place_.color, model.camera, owner_of);
    const double detects = Detects(spot.p_W, sight.X_WB, model);
    if (detects < model.least_detection && !has_box) continue;
    spot.log.Add({.time = sight.time,
                  .p_OC = sight.X_WB.p_WB - spot.p_W,
                  .detects = std::max(detects, model.least_detection),
                  .false_alarm = FalseAlarm(*prospect, model),
                  .has_box = has_box});
  }
}

double PlaceWatch::Lambda() const {
  double sum = std::log(spots_.front().weight) + spots_.front().log.Lambda();
  for (std::size_t i = 1; i < spots_.size(); ++i) {
    sum = LogSum(sum, std::log(spots_[i].weight) + spots_[i].log.Lambda());
  }
  return sum;
}

}  // namespace limpet
