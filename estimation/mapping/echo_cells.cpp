// SPDX-License-Identifier: MIT
#include "estimation/mapping/echo_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limpet {
namespace {

/// One echo outweighs two beams that pass close by: sonars miss edges, and rarely make echoes up.
constexpr int kEcho = 2, kPassage = 1;
/// Three echoes more than what speaks against them.
constexpr int kBelieved = 6;
constexpr int kMostWeight = 24;

}  // namespace

EchoCells::Key EchoCells::KeyOf(const Eigen::Vector3d& p_W) const {
  return {static_cast<std::int32_t>(std::floor(p_W.x() / cell_m_)),
          static_cast<std::int32_t>(std::floor(p_W.y() / cell_m_))};
}

void EchoCells::Lay(const Cell& laid) {
  Cell& cell = cells_[KeyOf(laid.p_W)];
  if (cell.weight <= 0) {
    cell = laid;
    return;
  }
  const double share = static_cast<double>(laid.weight) / (cell.weight + laid.weight);
  cell.p_W += share * (laid.p_W - cell.p_W);
  cell.shallowest = std::min(cell.shallowest, laid.shallowest);
  cell.deepest = std::max(cell.deepest, laid.deepest);
  cell.t = std::max(cell.t, laid.t);
  cell.weight = std::min(kMostWeight, cell.weight + laid.weight);
}

void EchoCells::AddEcho(double t, const Eigen::Vector3d& end_W) {
  Lay({.p_W = end_W, .shallowest = end_W.z(), .deepest = end_W.z(), .t = t, .weight = kEcho});
}

bool EchoCells::IsPassed(const Cell& cell, const PosedSonar& sonar, const Eigen::Matrix3d& R_WB) {
  constexpr double kBehind = 0.75;     // [m] so far behind the cell a beam must have gone
  constexpr double kNearEchoes = 0.1;  // [m] so near its echoes
  constexpr double kAbove = 0.2;       // [m] so far above them it may have gone over it
  const SonarPing& ping = sonar.ping;
  const Eigen::Vector3d off_B =
      R_WB.transpose() * (cell.p_W - Eigen::Vector3d(sonar.north, sonar.east, sonar.down));
  const double distance = off_B.head<2>().norm();
  const double bearing = std::atan2(off_B.y(), off_B.x());
  const double index = std::round((bearing - ping.first) / ping.step);
  if (!(index >= 0.0 && index < static_cast<double>(ping.ranges.size()))) return false;
  if (distance * std::abs(bearing - ping.first - index * ping.step) > kNearEchoes) return false;
  const double depth_there = sonar.down + (R_WB * Eigen::Vector3d(off_B.x(), off_B.y(), 0.0)).z();
  if (depth_there < cell.shallowest - kAbove) return false;
  const double range = ping.ranges[static_cast<std::size_t>(index)];
  return distance + kBehind < (range > 0.0 ? range : ping.reach);
}

void EchoCells::AddPassages(const PosedSonar& sonar) {
  if (cells_.empty() || sonar.ping.ranges.empty() || !(sonar.ping.step > 0.0)) return;
  const Eigen::Matrix3d R_WB = RotationOf(sonar.pose());
  for (auto& [key, cell] : cells_) {
    if (IsPassed(cell, sonar, R_WB)) cell.weight -= kPassage;
  }
  std::erase_if(cells_, [](const auto& entry) { return entry.second.weight <= 0; });
}

void EchoCells::Shift(const TrackShift& shift) {
  std::map<Key, Cell> before;
  before.swap(cells_);
  for (auto& [key, cell] : before) {
    const Eigen::Vector3d moved = shift.Apply(cell.t, {cell.p_W, 0.0, 0.0, 0.0}).p_WB - cell.p_W;
    cell.p_W += moved;
    cell.shallowest += moved.z();
    cell.deepest += moved.z();
    Lay(cell);
  }
}

std::vector<EchoCells::Cell> EchoCells::Believed() const {
  std::vector<Cell> believed;
  for (const auto& [key, cell] : cells_) {
    if (cell.weight >= kBelieved) believed.push_back(cell);
  }
  return believed;
}

}  // namespace limpet
