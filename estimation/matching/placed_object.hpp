// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <Eigen/Core>

namespace limpet {

/// An object of one session in that session's frame, NED.
struct PlacedObject {
  Eigen::Vector3d ned = Eigen::Vector3d::Zero();
  Eigen::Matrix3d cov = Eigen::Matrix3d::Identity();
  std::string color;
};

}  // namespace limpet
