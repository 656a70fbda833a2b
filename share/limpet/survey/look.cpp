// SPDX-License-Identifier: MIT
#include "limpet/survey/look.hpp"

#include <algorithm>

namespace limpet {
namespace {

/// Slack takes at most this share of a window's extents: who plans exactly over the place has done
/// what can be done.
constexpr double kMostSlackShare = 0.6;
constexpr int kBisections = 30;

/// Diameter of the object's image [px].
double SizeInImage(const LookModel& model, double range) {
  return 2.0 * model.object_radius * model.camera.fx / std::max(range, 1e-3);
}

}  // namespace

double ChanceToDetect(const LookModel& model, const Pose& X_WB, const Eigen::Vector3d& p_W) {
  const double share = VisibleShare(model.camera, X_WB, p_W, model.object_radius);
  if (share <= 0.0) return 0.0;
  const double range = (p_W - X_WB.p_WB).norm();
  return DetectionChance(model.detection, {.range = range, .share = share}) *
         SizeFactor(model.detection, SizeInImage(model, range));
}

PerVisibility ChancesToDetect(const LookModel& model, const Pose& X_WB, const Eigen::Vector3d& p_W,
                              const PerVisibility& visibilities) {
  const double share = VisibleShare(model.camera, X_WB, p_W, model.object_radius);
  if (share <= 0.0) return {0.0};
  const double range = (p_W - X_WB.p_WB).norm();
  return DetectionChances(model.detection, {.range = range, .share = share}, visibilities) *
         SizeFactor(model.detection, SizeInImage(model, range));
}

std::optional<LookWindow> LookWindowAbove(const LookModel& model, const PlaceBelow& place) {
  const double drop = place.drop;
  const double along = drop * model.camera.half_along();
  const double across = drop * model.camera.half_across();
  // The chance falls towards the corners; so where the corners are looked at, all within them is.
  const auto is_look = [&](double scale) {
    for (const double x : {-scale * along, scale * along}) {
      for (const double y : {-scale * across, scale * across}) {
        if (ChanceToDetect(model, Pose{}, {x, y, drop}) < kLookChance) {
          return false;
        }
      }
    }
    return true;
  };
  if (drop <= 0.0 || !is_look(0.0)) {
    return std::nullopt;
  }
  double inside = 0.0;
  double outside = 1.0;  // an object centred on the image's corner shows a quarter of itself
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (inside + outside);
    (is_look(middle) ? inside : outside) = middle;
  }
  const auto narrowed = [slack = place.slack](double half) {
    return std::max(half - slack, (1.0 - kMostSlackShare) * half);
  };
  return LookWindow{.half_along = narrowed(inside * along),
                    .half_across = narrowed(inside * across)};
}

MapLook ToMapLook(const LookModel& model) {
  return {.fov_across = model.camera.fov_across(),
          .fov_along = model.camera.fov_along(),
          .width_px = model.camera.width_px,
          .height_px = model.camera.height_px,
          .detection = model.detection,
          .object_radius = model.object_radius};
}

LookModel ToLookModel(const MapLook& look) {
  return {.camera = CameraModel::FromFieldOfView(
              look.width_px, look.height_px, {.across = look.fov_across, .along = look.fov_along}),
          .detection = look.detection,
          .object_radius = look.object_radius};
}

}  // namespace limpet
