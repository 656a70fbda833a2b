// SPDX-License-Identifier: MIT
#include "limpet/survey/view_cone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpet {
namespace {

constexpr double kReliefShare = 0.1;

}  // namespace

ViewCone::ViewCone(const Pose& X_WB, const CameraModel& camera, double disc_inset)
    : inset_(disc_inset) {
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Eigen::Matrix3d R_WC = R_WB * camera.R_BC;
  apex_ = X_WB.p_WB + R_WB * camera.p_BC;
  const double across = camera.half_across();
  const double along = camera.half_along();
  // In C: |x| <= across z and |y| <= along z.
  normals_ = {R_WC * Eigen::Vector3d(1.0, 0.0, across), R_WC * Eigen::Vector3d(-1.0, 0.0, across),
              R_WC * Eigen::Vector3d(0.0, 1.0, along), R_WC * Eigen::Vector3d(0.0, -1.0, along)};
  corners_ = {
      R_WC * Eigen::Vector3d(across, along, 1.0), R_WC * Eigen::Vector3d(across, -along, 1.0),
      R_WC * Eigen::Vector3d(-across, along, 1.0), R_WC * Eigen::Vector3d(-across, -along, 1.0)};
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    looks_down_ = looks_down_ && normals_[k].z() > 1e-6 && corners_[k].z() > 1e-6;
  }
}

std::optional<double> ViewCone::SeenHeight(const Eigen::Vector3d& p_W) const {
  if (!looks_down_) {
    return std::nullopt;
  }
  const Eigen::Vector3d from_apex = p_W - apex_;
  double height = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& normal : normals_) {
    const double depth_inside = normal.dot(from_apex) - drawn_in_;
    if (depth_inside < 0.0) {
      return std::nullopt;
    }
    // Rising by h changes the distance by -h normal.z.
    height = std::min(height, (depth_inside - inset_) / normal.z());
  }
  return std::max(0.0, height);
}

double ViewCone::Inside(const Eigen::Vector3d& p_W, double height, bool as_object) const {
  if (!looks_down_) {
    return -std::numeric_limits<double>::infinity();
  }
  const Eigen::Vector3d from_apex = p_W - apex_;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& normal : normals_) {
    least = std::min(least, normal.dot(from_apex) - height * normal.z());
  }
  return least - drawn_in_ - (as_object ? inset_ : 0.0);
}

CellBox ViewCone::CellsBelow(const GridFrame& frame, double seabed_down) const {
  const double drop = (1.0 + kReliefShare) * (seabed_down - apex_.z());
  if (!looks_down_ || drop <= 0.0) {
    return {};
  }
  Eigen::Vector2d low = apex_.head<2>(), high = apex_.head<2>();
  for (const Eigen::Vector3d& corner : corners_) {
    const Eigen::Vector2d hit = apex_.head<2>() + corner.head<2>() * (drop / corner.z());
    low = low.cwiseMin(hit);
    high = high.cwiseMax(hit);
  }
  const auto cell = [&frame](double offset, int count) {
    return static_cast<int>(
        std::clamp(std::floor(offset / frame.cell_m), -1.0, static_cast<double>(count)));
  };
  return {
      .row_min = std::max(0, cell(low.x() - frame.north_min, frame.rows)),
      .row_max = std::min(frame.rows - 1, cell(high.x() - frame.north_min, frame.rows)),
      .column_min = std::max(0, cell(low.y() - frame.east_min, frame.columns)),
      .column_max = std::min(frame.columns - 1, cell(high.y() - frame.east_min, frame.columns))};
}

}  // namespace limpet
