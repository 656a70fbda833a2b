// SPDX-License-Identifier: MIT
#include "estimation/change/tentative_objects.hpp"

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
constexpr int kMostTentative = 8;    ///< of one session, for a detector that sees ghosts
constexpr double kPlaceSigma = 0.3;  ///< of a tentative object's place [m]

bool IsOver(const TentativeObject& tentative) { return tentative.good_looks >= kEnoughLooks; }

void Look(TentativeObject& tentative, const ObservedFrame& frame, const WatchModel& model) {
  const double share =
      VisibleShare(model.look.camera, frame.X_WB, tentative.place.p_W, model.look.object_radius);
  const Eigen::Vector3d& eye = frame.X_WB.p_WB;
  const bool is_new =
      !tentative.last_viewpoint_W || (*tentative.last_viewpoint_W - eye).norm() >= kNewViewpoint;
  if (share >= kWhole && is_new) {
    ++tentative.good_looks;
    tentative.last_viewpoint_W = eye;
  }
}

}  // namespace

std::optional<Eigen::Vector3d> PlaceOfBox(const Box& box, const ObservedFrame& frame,
                                          const WatchModel& model) {
  const CameraModel& camera = model.look.camera;
  const BoxExtent u = ExtentAcross(box, camera), v = ExtentAlong(box, camera);
  if (u.is_cut() && v.is_cut()) {
    return std::nullopt;
  }
  const double across = box.w / camera.fx;
  const double along = box.h / camera.fy;
  const double size = u.is_cut() ? along : (v.is_cut() ? across : 0.5 * (across + along));
  const double depth = 2.0 * model.look.object_radius / std::max(size, 1e-3);
  const double deepest =
      frame.altitude.value_or(model.look.detection.visibility.value()) + kBelowSeabed;
  if (depth < kNearestDepth || depth > deepest) {
    return std::nullopt;
  }
  const double half = model.look.object_radius / depth;
  const Eigen::Vector3d p_C(depth * (u.CentreOf(half * camera.fx) - camera.cx) / camera.fx,
                            depth * (v.CentreOf(half * camera.fy) - camera.cy) / camera.fy, depth);
  return frame.X_WB.p_WB + RotationOf(frame.X_WB) * (camera.R_BC * p_C + camera.p_BC);
}

void TentativeObjects::AddFrame(const ObservedFrame& frame, const WatchModel& model,
                                const IsExplained& is_explained) {
  now_ = frame.exposure.value();
  std::erase_if(tentative_, [this](const TentativeObject& tentative) {
    return tentative.boxes < kEnoughBoxes && now_ - tentative.last_box > kOnePass;
  });
  for (TentativeObject& tentative : tentative_) {
    Look(tentative, frame, model);
  }
  for (const Box& box : frame.boxes) {
    if (is_explained(frame, box)) continue;
    if (const std::optional<Eigen::Vector3d> p_W = PlaceOfBox(box, frame, model)) {
      Take(*p_W, box.color, frame.exposure.value());
    } else {
      Support(box, frame, model);
    }
  }
}

void TentativeObjects::Take(const Eigen::Vector3d& p_W, const std::string& color, double time) {
  const auto near = std::ranges::find_if(tentative_, [&](const TentativeObject& tentative) {
    return tentative.place.color == color && (tentative.place.p_W - p_W).norm() < kOneObject;
  });
  if (near == tentative_.end()) {
    tentative_.push_back(
        {.place = {.p_W = p_W,
                   .cov_W = kPlaceSigma * kPlaceSigma * Eigen::Matrix3d::Identity(),
                   .color = color},
         .boxes = 1,
         .places = 1,
         .last_box = time,
         .last_viewpoint_W = {}});
    return;
  }
  ++near->boxes;
  ++near->places;
  near->place.p_W += (p_W - near->place.p_W) / near->places;
  near->last_box = time;
}

void TentativeObjects::Support(const Box& box, const ObservedFrame& frame,
                               const WatchModel& model) {
  for (TentativeObject& tentative : tentative_) {
    const std::optional<Foresight> foresight = Foresee(tentative.place, frame.X_WB, model);
    const bool is_recent = frame.exposure.value() - tentative.last_box <= kOnePass;
    if (is_recent && tentative.place.color == box.color && foresight &&
        foresight->Explains(box, model.look.camera)) {
      ++tentative.boxes;
      tentative.last_box = frame.exposure.value();
      return;
    }
  }
}

std::vector<TentativeObject*> TentativeObjects::Open() {
  std::vector<TentativeObject*> open;
  for (TentativeObject& tentative : tentative_) {
    const double age = now_ - tentative.last_box;
    const bool is_open = tentative.boxes >= kEnoughBoxes && !IsOver(tentative) &&
                         age > kLeftTheImage && age < kGrownOld;
    if (!is_open) continue;
    if (!tentative.is_counted && counted_ >= kMostTentative) {
      left_out_ += tentative.is_left_out ? 0 : 1;
      tentative.is_left_out = true;
      continue;
    }
    counted_ += tentative.is_counted ? 0 : 1;
    tentative.is_counted = true;
    open.push_back(&tentative);
  }
  return open;
}

}  // namespace limpet
