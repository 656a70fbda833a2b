// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "estimation/mapping/dvl_beams.hpp"

namespace limpet {

/// The seabed around the vehicle as a plane, by the DVL's beams of late: how deep it is ahead where
/// nothing has been there yet.
class GroundSlope {
 public:
  /// A ping, `X_WD` the DVL's place with the body's attitude; ranges in metres.
  void Add(const Pose& X_WD, const std::array<std::optional<double>, 4>& ranges,
           const DvlBeams& dvl);
  /// NED depth there [m]; nothing before the first ping of three beams or more.
  [[nodiscard]] std::optional<double> DepthAt(const Eigen::Vector2d& p_W) const;

 private:
  Eigen::Vector3d below_W_ =
      Eigen::Vector3d::Zero();                       ///< where the latest beams met it, on average
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();  ///< deeper per metre north, east
  bool is_known_ = false;
};

}  // namespace limpet
