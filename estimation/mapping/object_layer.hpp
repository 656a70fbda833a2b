// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "estimation/change/object_statuses.hpp"
#include "estimation/mapping/object_look.hpp"
#include "estimation/mapping/sampled_sphere.hpp"
#include "estimation/mapping/semantic_map.hpp"
#include "estimation/mapping/voxel_cluster.hpp"

namespace limpet {

/// Paints the objects of the smoother into the semantic map, from independent looks only. Keeps
/// the looks, so that an object whose landmark moves takes its voxels along.
class ObjectLayer {
 public:
  struct Params {
    double threshold = 0.7;  ///< P_a of an object's voxel
    Meters repaint_at{0.1};  ///< a landmark that moves farther takes its voxels along
  };

  ObjectLayer(const Params& params, const StatusParams& status, const CameraModel& camera)
      : params_(params), status_(status), camera_(camera) {}

  /// Another detection, as water is other than was thought: all looks are judged anew by it when
  /// objects are set next.
  void SetDetection(const DetectionModel& detection);
  /// One frame: at most one look at each known object.
  void AddFrame(const ObservedFrame& frame, const ObjectStatuses& statuses);
  /// All objects as now believed; new ones are judged from all frames of `statuses`. Paints what
  /// has changed. What no look of this session showed has no voxels, nor has what is removed.
  void SetObjects(const std::vector<OpiBelief>& objects, const ObjectStatuses& statuses,
                  SemanticMap& map);
  /// The object's largest cluster of voxels; nothing before they pass the threshold.
  [[nodiscard]] std::optional<ObjectCluster> Cluster(int object) const;

 private:
  struct Painted {
    OpiBelief status;
    std::vector<ObjectLook> looks;                  ///< with a box
    double miss_log_odds = 0.0;                     ///< of passes with looks that had none
    std::optional<double> last_miss;                ///< time [s]
    std::optional<Eigen::Vector3d> last_viewpoint;  ///< camera relative to the object [m]
    Eigen::Vector3d judged_at_W = Eigen::Vector3d::Zero();
    std::map<VoxelKey, double> log_odds;  ///< P_a per voxel, as painted
    std::optional<ObjectCluster> cluster;
    bool is_stale = true;
    bool is_of_other_water = false;  ///< its looks were judged by another detection than now
  };

  void Look(Painted& object, const ObservedFrame& frame, const ObjectStatuses& statuses) const;
  [[nodiscard]] bool IsNewLook(const Painted& object, const Eigen::Vector3d& p_OC) const;
  [[nodiscard]] double RadiusOf(const Painted& object) const;
  /// What a frame without a box says; 0 where it would more likely than not have
  /// been overlooked.
  [[nodiscard]] double MissLogOdds(const Pose& X_WB, const Painted& object) const;
  /// Takes the object's looks from all frames of `statuses`.
  void Judge(Painted& object, const ObjectStatuses& statuses) const;
  void Follow(Painted& object, const OpiBelief& status, const ObjectStatuses& statuses) const;
  void Repaint(Painted& object, SemanticMap& map) const;
  [[nodiscard]] std::map<VoxelKey, double> Gather(const Painted& object,
                                                  const SampledSphere& voxels) const;

  Params params_;
  StatusParams status_;
  CameraModel camera_;
  std::map<int, Painted> objects_;  ///< by OpiBelief::id
};

}  // namespace limpet
