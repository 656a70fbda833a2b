// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "estimation/association/camera_mount.hpp"
#include "estimation/association/tracked_object.hpp"
#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

/// What is known of objects before any observation.
struct ObjectModel {
  BoxNoise noise;
  double radius_m = 0.5;  ///< 0: unknown
  double height_m = 0.9;  ///< of the centre above the seabed
  double height_sigma_m = 0.8;
  double huber = 1.345;
};

struct Triangulation {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();             ///< [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< [m^2]
  double worst_residual = 0.0;                               ///< whitened, over the observations
};

/// Where an object is, from its observations at poses taken as known: bearing, range of whole
/// boxes, and the seabed below the first observation; the camera as estimated now.
[[nodiscard]] Triangulation Triangulate(const std::vector<Observation>& observations,
                                        const std::function<NavVector(int)>& pose_of,
                                        const CameraMount& mount, const ObjectModel& model);

/// The terms that an observation puts on pose and landmark, and on the camera's errors; none for a
/// box that both borders cut. `with_seabed`: also the weak hint of the seabed's depth, once per
/// pass.
[[nodiscard]] std::vector<Term> TermsOf(const Observation& observation, int slot,
                                        const CameraMount& mount, const ObjectModel& model,
                                        bool with_seabed);

}  // namespace limpet
