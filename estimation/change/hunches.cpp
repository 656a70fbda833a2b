// SPDX-License-Identifier: MIT
#include "estimation/change/hunches.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kBelowSeabed = 0.7;   ///< a place may seem this far below the seabed [m]
constexpr double kNearestDepth = 0.5;  ///< [m]
constexpr double kOneObject = 1.2;     ///< boxes whose places are nearer hint at one object [m]
constexpr int kEnoughBoxes = 3;        ///< of one pass
constexpr double kOnePass = 20.0;      ///< too few boxes are forgotten after that [s]
constexpr double kLeftTheImage = 3.0;  ///< while boxes come, the smoother may still make it one [s]
constexpr double kGrownOld = 400.0;    ///< a place that nobody could reach by then is given up [s]
constexpr double kWhole = 0.95;        ///< share inside the image that is as good as all
constexpr double kNewViewpoint = 0.5;  ///< between good looks [m]
constexpr int kEnoughLooks = 3;
constexpr int kMostHunches = 8;      ///< of one session, for a detector that sees ghosts
constexpr double kPlaceSigma = 0.3;  ///< of a hunch's place [m]

bool IsOver(const Hunch& hunch) { return hunch.good_looks >= kEnoughLooks; }

void Look(Hunch& hunch, const ObservedFrame& sight, const WatchModel& model) {
  const double share = VisibleShare(model.camera, sight.X_WB, hunch.place.p_W, model.object_radius);
  const Eigen::Vector3d& eye = sight.X_WB.p_WB;
  const bool is_new =
      !hunch.last_viewpoint || (*hunch.last_viewpoint - eye).norm() >= kNewViewpoint;
  if (share >= kWhole && is_new) {
    ++hunch.good_looks;
    hunch.last_viewpoint = eye;
  }
}

}  // namespace

std::optional<Eigen::Vector3d> PlaceOfBox(const Box& box, const ObservedFrame& sight,
                                          const WatchModel& model) {
  const CameraModel& camera = model.camera;
  const BoxExtent u = ExtentAcross(box, camera), v = ExtentAlong(box, camera);
  if (u.is_cut() && v.is_cut()) {
    return std::nullopt;
  }
  const double across = box.w / camera.fx;
  const double along = box.h / camera.fy;
  const double size = u.is_cut() ? along : (v.is_cut() ? across : 0.5 * (across + along));
  const double depth = 2.0 * model.object_radius / std::max(size, 1e-3);
  const double deepest = sight.altitude.value_or(model.detection.visibility.value()) + kBelowSeabed;
  if (depth < kNearestDepth || depth > deepest) {
    return std::nullopt;
  }
  const double half = model.object_radius / depth;
  const Eigen::Vector3d p_C(depth * (u.CentreOf(half * camera.fx) - camera.cx) / camera.fx,
                            depth * (v.CentreOf(half * camera.fy) - camera.cy) / camera.fy, depth);
  return sight.X_WB.p_WB + RotationOf(sight.X_WB) * (camera.R_BC * p_C + camera.p_BC);
}

void HunchBook::AddSight(const ObservedFrame& sight, const WatchModel& model,
                         const IsExplained& is_explained) {
  now_ = sight.exposure.value();
  std::erase_if(hunches_, [this](const Hunch& hunch) {
    return hunch.boxes < kEnoughBoxes && now_ - hunch.last_box > kOnePass;
  });
  for (Hunch& hunch : hunches_) {
    Look(hunch, sight, model);
  }
  for (const Box& box : sight.boxes) {
    if (is_explained(sight, box)) continue;
    if (const std::optional<Eigen::Vector3d> p_W = PlaceOfBox(box, sight, model)) {
      Take(*p_W, box.color, sight.exposure.value());
    } else {
      Support(box, sight, model);
    }
  }
}

void HunchBook::Take(const Eigen::Vector3d& p_W, const std::string& color, double time) {
  const auto near = std::ranges::find_if(hunches_, [&](const Hunch& hunch) {
    return hunch.place.color == color && (hunch.place.p_W - p_W).norm() < kOneObject;
  });
  if (near == hunches_.end()) {
    hunches_.push_back({.place = {.p_W = p_W,
                                  .cov_W = kPlaceSigma * kPlaceSigma * Eigen::Matrix3d::Identity(),
                                  .color = color},
                        .boxes = 1,
                        .places = 1,
                        .last_box = time,
                        .last_viewpoint = {}});
    return;
  }
  ++near->boxes;
  ++near->places;
  near->place.p_W += (p_W - near->place.p_W) / near->places;
  near->last_box = time;
}

void HunchBook::Support(const Box& box, const ObservedFrame& sight, const WatchModel& model) {
  for (Hunch& hunch : hunches_) {
    const std::optional<Foresight> foresight = Foresee(hunch.place, sight.X_WB, model);
    const bool is_recent = sight.exposure.value() - hunch.last_box <= kOnePass;
    if (is_recent && hunch.place.color == box.color && foresight &&
        foresight->Explains(box, model.camera)) {
      ++hunch.boxes;
      hunch.last_box = sight.exposure.value();
      return;
    }
  }
}

std::vector<Hunch*> HunchBook::Open() {
  std::vector<Hunch*> open;
  for (Hunch& hunch : hunches_) {
    const double age = now_ - hunch.last_box;
    const bool is_open =
        hunch.boxes >= kEnoughBoxes && !IsOver(hunch) && age > kLeftTheImage && age < kGrownOld;
    if (!is_open) continue;
    if (!hunch.is_counted && counted_ >= kMostHunches) {
      left_out_ += hunch.is_left_out ? 0 : 1;
      hunch.is_left_out = true;
      continue;
    }
    counted_ += hunch.is_counted ? 0 : 1;
    hunch.is_counted = true;
    open.push_back(&hunch);
  }
  return open;
}

}  // namespace limpet
