// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Echoes of what stands up, by cells of the plane: an echo speaks for its cell, a beam that goes
/// through speaks against it. Moves along when the smoother moves the way behind.
class EchoCells {
 public:
  struct Cell {
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< mean of its echoes
    double shallowest = 0.0, deepest = 0.0;         ///< of them, NED depth [m]
    double t = 0.0;                                 ///< of the last one, MOOS time [s]
    int weight = 0;
  };

  explicit EchoCells(double cell_m) : cell_m_(cell_m) {}

  void AddEcho(double t, const Eigen::Vector3d& end_W);
  /// A ping of the sonar: beams that went on through a cell speak against it.
  void AddPassages(const PosedSonar& sonar);
  void Shift(const TrackShift& shift);

  /// Cells that are believed, in a fixed order.
  [[nodiscard]] std::vector<Cell> Believed() const;
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] bool is_empty() const { return cells_.empty(); }

 private:
  using Key = std::pair<std::int32_t, std::int32_t>;
  [[nodiscard]] Key KeyOf(const Eigen::Vector3d& p_W) const;
  /// A beam went on behind where the cell's echoes came from.
  [[nodiscard]] static bool IsPassed(const Cell& cell, const PosedSonar& sonar,
                                     const Eigen::Matrix3d& R_WB);
  void Lay(const Cell& cell);

  double cell_m_;
  std::map<Key, Cell> cells_;
};

}  // namespace limpet
