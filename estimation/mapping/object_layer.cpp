// SPDX-License-Identifier: MIT
#include "estimation/mapping/object_layer.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/mapping/status_label.hpp"
#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kWellVisible = 0.75;  ///< share of the object inside the image that makes a look
constexpr float kOccupiedPerLook = 0.85F;
/// An object that moved farther than this is judged again from all frames [m].
constexpr double kRejudgeDistance = 0.3;

/// What is certain has log odds that voxels can hold.
constexpr Interval kUncertain{.low = 1e-6, .high = 1.0 - 1e-6};

}  // namespace

void ObjectLayer::SetDetection(const DetectionModel& detection) {
  status_.detection = detection;
  for (auto& [id, object] : objects_)
    object.is_of_other_water = true;
}

bool ObjectLayer::IsNewLook(const Painted& object, const Eigen::Vector3d& p_OC) const {
  return !object.last_viewpoint || status_.looks.IsNewLook(p_OC, *object.last_viewpoint);
}

double ObjectLayer::RadiusOf(const Painted& object) const {
  return object.status.object.RadiusOr(status_.object_radius.value());
}

double ObjectLayer::MissLogOdds(const Pose& X_WB, const Painted& object) const {
  const Eigen::Vector3d& p_W = object.status.object.p_W;
  const double radius = RadiusOf(object);
  if (VisibleShare(camera_, X_WB, p_W, radius) < kWellVisible) {
    return 0.0;
  }
  const double detects = ChanceToDetect(
      {.camera = camera_, .detection = status_.detection, .object_radius = radius}, X_WB, p_W);
  if (detects < kLookChance) return 0.0;  // most likely it would not have been seen
  const double false_alarm = status_.detection.false_per_image;
  return std::min(std::log((1.0 - detects) / (1.0 - false_alarm)), 0.0);
}

void ObjectLayer::Look(Painted& object, const ObservedFrame& frame,
                       const ObjectStatuses& statuses) const {
  const Eigen::Vector3d& p_W = object.status.object.p_W;
  const Eigen::Vector3d p_OC = frame.X_WB.p_WB - p_W;
  if (!object.status.landmark || !IsNewLook(object, p_OC)) {
    return;
  }
  if (const Box* box = statuses.BoxOf(object.status, frame)) {
    const double depth = camera_.InCamera(frame.X_WB, p_W).z();
    const Eigen::Vector2d half_px =
        RadiusOf(object) / depth * Eigen::Vector2d(camera_.fx, camera_.fy);
    object.looks.push_back({.X_WB = frame.X_WB,
                            .box = WholeBox(*box, half_px, camera_),
                            .object_W = p_W,
                            .time = frame.exposure.value()});
  } else {
    const double miss = MissLogOdds(frame.X_WB, object);
    if (miss == 0.0) return;
    // What made one look of a pass miss may have made them all: they are one witness.
    const bool is_new_pass = !object.last_miss || frame.exposure.value() - *object.last_miss >
                                                      status_.looks.new_pass_gap.value();
    object.miss_log_odds += is_new_pass ? miss : 0.0;
    object.last_miss = frame.exposure.value();
  }
  object.last_viewpoint = p_OC;
  object.is_stale = true;
}

void ObjectLayer::AddFrame(const ObservedFrame& frame, const ObjectStatuses& statuses) {
  for (auto& [id, object] : objects_) {
    Look(object, frame, statuses);
  }
}

void ObjectLayer::Judge(Painted& object, const ObjectStatuses& statuses) const {
  std::map<double, Eigen::Vector3d> object_W;  // a look keeps to where the object was thought to be
  for (const ObjectLook& look : object.looks) {
    object_W[look.time] = look.object_W;
  }
  object.looks.clear();
  object.miss_log_odds = 0.0;
  object.last_miss.reset();
  object.last_viewpoint.reset();
  object.judged_at_W = object.status.object.p_W;
  object.is_of_other_water = false;
  for (const ObservedFrame& frame : statuses.frames()) {
    Look(object, frame, statuses);
  }
  for (ObjectLook& look : object.looks) {
    const auto known = object_W.find(look.time);
    look.object_W = known != object_W.end() ? known->second : look.object_W;
  }
}

void ObjectLayer::Follow(Painted& object, const OpiBelief& status,
                         const ObjectStatuses& statuses) const {
  const bool is_another = object.status.landmark != status.landmark;
  const double moved = (object.status.object.p_W - status.object.p_W).norm();
  object.is_stale = object.is_stale || is_another || moved > params_.repaint_at.value() ||
                    object.status.decided != status.decided;
  const Eigen::Vector3d painted_at = object.status.object.p_W;
  object.status = status;
  if (is_another) {
    object.looks.clear();
  }
  // At a place where it was thought to be before, frames showed nothing: no evidence against it.
  if (is_another || object.is_of_other_water ||
      (object.judged_at_W - status.object.p_W).norm() > kRejudgeDistance) {
    Judge(object, statuses);
    object.is_stale = true;
  } else if (!object.is_stale) {
    object.status.object.p_W = painted_at;  // small steps add up until they are worth a repaint
  }
}

void ObjectLayer::SetObjects(const std::vector<OpiBelief>& objects, const ObjectStatuses& statuses,
                             SemanticMap& map) {
  std::map<int, Painted> kept;
  for (const OpiBelief& status : objects) {
    const auto known = objects_.find(status.id);
    Painted object = known != objects_.end() ? std::move(known->second) : Painted{};
    if (known != objects_.end()) {
      objects_.erase(known);
    }
    Follow(object, status, statuses);
    kept.emplace(status.id, std::move(object));
  }
  for (const auto& [id, gone] : objects_) {
    for (const auto& [key, log_odds] : gone.log_odds) {
      map.Unpaint(key);
    }
  }
  objects_ = std::move(kept);
  for (auto& [id, object] : objects_) {
    if (object.is_stale) {
      Repaint(object, map);
    }
  }
}

std::map<VoxelKey, double> ObjectLayer::Gather(const Painted& object,
                                               const SampledSphere& voxels) const {
  std::map<VoxelKey, double> sum;
  if (object.status.decided == Status::kRemoved) return sum;  // nothing stands there
  for (const ObjectLook& look : object.looks) {
    const Eigen::Vector3d shift = object.status.object.p_W - look.object_W;
    std::map<VoxelKey, double> strongest;  // many rays of one look in one voxel are one witness
    for (const VoxelEvidence& point :
         NearSurface(look, camera_, {.radius = voxels.radius, .spacing = 0.5 * voxels.spacing})) {
      double& best = strongest[KeyOf(point.p_W + shift, voxels.spacing)];
      best = std::max(best, point.log_odds);
    }
    for (const auto& [key, log_odds] : strongest) {
      sum[key] += log_odds;
    }
  }
  for (auto& [key, log_odds] : sum) {
    log_odds += object.miss_log_odds;
  }
  return sum;
}

void ObjectLayer::Repaint(Painted& object, SemanticMap& map) const {
  double radius = object.looks.empty() ? RadiusOf(object) : 0.0;
  for (const ObjectLook& look : object.looks) {
    radius += RadiusFromBox(look, camera_) / static_cast<double>(object.looks.size());
  }
  const SampledSphere voxels{.radius = radius, .spacing = map.resolution()};
  std::map<VoxelKey, double> painted = Gather(object, voxels);
  for (const auto& [key, log_odds] : object.log_odds) {
    if (!painted.contains(key)) {
      map.Unpaint(key);
    }
  }
  const auto looks = static_cast<float>(std::max<std::size_t>(object.looks.size(), 1));
  const auto exists = static_cast<float>(LogOddsOf(object.status.posterior.present(), kUncertain));
  std::vector<VoxelKey> certain;
  for (const auto& [key, log_odds] : painted) {
    map.Paint(key, {.occupied = kOccupiedPerLook * looks,
                    .object = static_cast<float>(log_odds),
                    .exists = exists,
                    .label = LabelOf(object.status.decided)});
    if (log_odds > LogOddsOf(params_.threshold, kUncertain)) {
      certain.push_back(key);
    }
  }
  object.log_odds = std::move(painted);
  object.cluster = LargestCluster(certain, voxels);
  object.is_stale = false;
}

std::optional<ObjectCluster> ObjectLayer::Cluster(int object) const {
  const auto found = objects_.find(object);
  return found == objects_.end() ? std::nullopt : found->second.cluster;
}

}  // namespace limpet
