// SPDX-License-Identifier: MIT
#include "limpet/recordings/beam_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace limpet {
namespace {

constexpr int kLeastPings = 20;
/// Below this share of the greatest, a direction of the beams' speeds was not moved along.
constexpr double kLeastShare = 1e-3;

std::optional<Eigen::Vector4d> FourSpeeds(const DvlPing& ping) {
  Eigen::Vector4d speeds;
  for (std::size_t beam = 0; beam < 4; ++beam) {
    if (!ping.beam_speeds[beam]) return std::nullopt;
    speeds[static_cast<Eigen::Index>(beam)] = *ping.beam_speeds[beam];
  }
  return speeds;
}

template <class Value>
std::array<Value, 4> OfRows(const Eigen::Matrix<double, 4, 3>& D,
                            Value (*of)(const Eigen::Vector3d&)) {
  std::array<Value, 4> values{of(D.row(0)), of(D.row(1)), of(D.row(2)), of(D.row(3))};
  return values;
}

}  // namespace

std::optional<BeamGeometry> BeamGeometry::Estimate(const std::vector<DvlPing>& pings) {
  Eigen::Matrix4d bb = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 3, 4> vb = Eigen::Matrix<double, 3, 4>::Zero();
  BeamGeometry geometry;
  for (const DvlPing& ping : pings) {
    const auto speeds = FourSpeeds(ping);
    if (!speeds || !ping.v_D) continue;
    bb += *speeds * speeds->transpose();
    vb += *ping.v_D * speeds->transpose();
    ++geometry.pings_;
  }
  if (geometry.pings_ < kLeastPings || !bb.allFinite() || !vb.allFinite()) return std::nullopt;
  // Speeds that agree perfectly span three directions only; then the least M is the right one.
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> known;
  known.setThreshold(kLeastShare * kLeastShare);
  known.compute(bb);
  if (known.rank() < 3) return std::nullopt;
  const Eigen::Matrix<double, 3, 4> M = known.solve(vb.transpose()).transpose();
  const Eigen::Matrix3d MM = M * M.transpose();
  const Eigen::FullPivLU<Eigen::Matrix3d> invertible(MM);
  if (!MM.allFinite() || !invertible.isInvertible()) return std::nullopt;
  geometry.D_ = M.transpose() * invertible.inverse();
  return geometry.D_.allFinite() ? std::optional(geometry) : std::nullopt;
}

std::optional<Eigen::Vector3d> BeamGeometry::Velocity(const DvlPing& ping) const {
  Eigen::Matrix3d DD = Eigen::Matrix3d::Zero();
  Eigen::Vector3d Db = Eigen::Vector3d::Zero();
  int good = 0;
  for (std::size_t beam = 0; beam < 4; ++beam) {
    if (!ping.beam_speeds[beam]) continue;
    const Eigen::Vector3d direction = D_.row(static_cast<Eigen::Index>(beam));
    DD += direction * direction.transpose();
    Db += direction * *ping.beam_speeds[beam];
    ++good;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> invertible(DD);
  if (good < 3 || !invertible.isInvertible()) return std::nullopt;
  return invertible.solve(Db);
}

std::optional<double> BeamGeometry::Contradiction(const DvlPing& ping) const {
  const auto speeds = FourSpeeds(ping);
  const auto velocity = Velocity(ping);
  if (!speeds || !velocity) return std::nullopt;
  return (*speeds - D_ * *velocity).norm();
}

std::array<Radians, 4> BeamGeometry::tilts() const {
  return OfRows<Radians>(D_, [](const Eigen::Vector3d& direction) {
    return Radians(std::atan2(direction.head<2>().norm(), std::abs(direction.z())));
  });
}

std::array<Radians, 4> BeamGeometry::azimuths() const {
  return OfRows<Radians>(D_, [](const Eigen::Vector3d& direction) {
    const double sign = direction.z() < 0.0 ? -1.0 : 1.0;
    return Radians(std::atan2(sign * direction.y(), sign * direction.x()));
  });
}

std::array<double, 4> BeamGeometry::lengths() const {
  return OfRows<double>(D_, [](const Eigen::Vector3d& direction) { return direction.norm(); });
}

}  // namespace limpet
