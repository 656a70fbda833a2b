// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// An object of a former session, in that session's frame.
struct FormerObject {
  int id = 0;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  std::string color;
};

/// An object of this session to be matched.
struct PresentObject {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  std::string color;
};

struct SessionMatchingParams {
  Meters offset_sigma{0.8};        ///< per horizontal axis between two sessions' frames: GPS
  Meters offset_sigma_down{0.05};  ///< and vertical: pressure
  Radians heading_sigma = Radians::FromTextUnit(0.7);
  Meters place_sigma{0.15};  ///< of an object that stayed, beyond its covariances
  double chi2_gate = 16.3;
};

/// Which former object each present one is (its id, or -1), one to one, under one common offset of
/// the sessions' frames. The offset is what most matches agree on, so that objects that went or
/// came do not move it.
[[nodiscard]] std::vector<int> MatchSessions(const std::vector<FormerObject>& former,
                                             const std::vector<PresentObject>& present,
                                             const SessionMatchingParams& params);

}  // namespace limpet
