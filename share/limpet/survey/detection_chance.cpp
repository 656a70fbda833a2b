// SPDX-License-Identifier: MIT
#include "limpet/survey/detection_chance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/logistic.hpp"
#include "limpet/core/smooth_step.hpp"

namespace limpet {
namespace {

constexpr double kSizeFallOff = 0.1;  ///< over the least size
constexpr int kDiscPoints = 24;

/// Factor on the chance for an object of which `share` is inside the image.
double InsideFactor(const DetectionModel& detector, double share) {
  const double way =
      (share - detector.share_none) / std::max(detector.share_full - detector.share_none, 1e-6);
  return SmoothStep(std::clamp(way, 0.0, 1.0));
}

/// Share of the contrast that reaches a camera `range` metres away in water of this visibility [m].
double Contrast(const DetectionModel& detector, double range, double visibility) {
  return Logistic((detector.half_range * visibility - range) / (detector.fall_off * visibility));
}

/// Offset of the i-th of kDiscPoints points spread evenly over the unit disc (sunflower).
Eigen::Vector2d DiscPoint(int i) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt((i + 0.5) / kDiscPoints);
  return {radius * std::cos(golden * i), radius * std::sin(golden * i)};
}

}  // namespace

double DetectionChance(const DetectionModel& detector, const Showing& object) {
  return detector.best * Contrast(detector, object.range, detector.visibility.value()) *
         InsideFactor(detector, object.share);
}

PerVisibility DetectionChances(const DetectionModel& detector, const Showing& object,
                               const PerVisibility& visibilities) {
  const double inside = InsideFactor(detector, object.share);
  return visibilities.unaryExpr([&](double reach) {
    return detector.best * Contrast(detector, object.range, reach) * inside;
  });
}

double SizeFactor(const DetectionModel& detector, double size_px) {
  const double least = detector.least_size_px;
  return Logistic((size_px - least) / (kSizeFallOff * least));
}

double HalfRange(const DetectionModel& detector) {
  return detector.half_range * detector.visibility.value();
}

Meters MeanVisibility(const DetectionModel& detector, const VisibilityBelief& water) {
  constexpr int kBisections = 40;
  double sure = 0.0, hopeless = 2.0 * VisibilityBelief::kMost_m;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (sure + hopeless);
    const PerVisibility contrast = VisibilityBelief::Grid().unaryExpr(
        [&](double reach) { return Contrast(detector, middle, reach); });
    (water.Expect(contrast) > 0.5 ? sure : hopeless) = middle;
  }
  return Meters(sure / detector.half_range);
}

double VisibleShare(const CameraModel& camera, const Pose& X_WB, const Eigen::Vector3d& p_W,
                    double radius) {
  const Eigen::Vector3d p_C = camera.InCamera(X_WB, p_W);
  if (p_C.z() < 0.1) {
    return 0.0;
  }
  const double u = camera.cx + camera.fx * p_C.x() / p_C.z();
  const double v = camera.cy + camera.fy * p_C.y() / p_C.z();
  const double radius_u = camera.fx * radius / p_C.z();
  const double radius_v = camera.fy * radius / p_C.z();
  int inside = 0;
  for (int i = 0; i < kDiscPoints; ++i) {
    const Eigen::Vector2d offset = DiscPoint(i);
    const double pu = u + radius_u * offset.x();
    const double pv = v + radius_v * offset.y();
    inside += pu >= 0.0 && pu < camera.width_px && pv >= 0.0 && pv < camera.height_px ? 1 : 0;
  }
  return static_cast<double>(inside) / kDiscPoints;
}

}  // namespace limpet
