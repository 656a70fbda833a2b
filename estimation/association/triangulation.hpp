// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "estimation/association/camera_mount.hpp"
#include "estimation/association/object_sizes.hpp"
#include "estimation/association/observation.hpp"
#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

/// ObjectModel::size_spread where one radius is said for objects of several sizes.
inline constexpr double kSizeSpread = 0.2;

/// What is known of objects before any observation.
struct ObjectModel {
  BoxNoise noise;
  double radius_m = 0.5;     ///< 0: unknown
  double size_spread = 0.0;  ///< 1-sigma of the natural logarithm of a radius's share of that
  std::map<std::string, double> class_radius_m;  ///< of classes with one of their own
  double height_m = 0.9;                         ///< of the centre above the seabed
  double height_sigma_m = 0.8;
  double huber = 1.345;

  /// What is believed of a class's size before it is seen: natural logarithm of its share of
  /// radius_m.
  [[nodiscard]] double LogSizeOf(const std::string& color) const {
    const auto own = class_radius_m.find(color);
    return own == class_radius_m.end() || !(radius_m > 0.0) ? 0.0
                                                            : std::log(own->second / radius_m);
  }
};

struct Triangulation {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();               ///< [m]
  Eigen::Matrix3d covariance_W = Eigen::Matrix3d::Identity();  ///< [m^2]
  double log_size = 0.0;        ///< natural logarithm of its share of the believed radius
  double worst_residual = 0.0;  ///< whitened, over the observations
};

/// What a look at a mapped object depends on beside the pose.
struct LookSlots {
  int landmark = 0;
  std::optional<CameraMount::Slots> mount{};
  std::optional<SizeSlot> size{};  ///< REQUIRES: only with a mount
};

/// Where an object is and how large, from its observations at poses taken as known: bearing, range
/// of whole boxes, and the seabed below the first observation; the camera as estimated now.
[[nodiscard]] Triangulation Triangulate(const std::vector<Observation>& observations,
                                        const std::function<NavVector(int)>& pose_of,
                                        const CameraMount& mount, const ObjectModel& model);

/// The terms that an observation puts on pose and landmark, and on the camera's errors and the
/// object's size where those are estimated; none for a box that both borders cut. `camera`: as its
/// file says; must outlive the terms. `with_seabed`: also the weak hint of the seabed's depth, once
/// per pass.
[[nodiscard]] std::vector<Term> TermsOf(const Observation& observation, const LookSlots& slots,
                                        const CameraModel& camera, const ObjectModel& model,
                                        bool with_seabed);

}  // namespace limpet
