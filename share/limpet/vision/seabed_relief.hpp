// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// Depth of the seabed [m] at (north, east) [m].
using SeabedDepthFunction = std::function<double(const Eigen::Vector2d& p_W)>;

/// Remembers a seabed on a lattice, so that a costly depth function is asked once per node. Grows
/// where it is looked at. Not thread-safe.
class SeabedRelief {
 public:
  explicit SeabedRelief(SeabedDepthFunction depth) : depth_(std::move(depth)) {}

  /// Depth [m] and its slopes towards north and east at a place, bilinear between nodes.
  struct Surface {
    double depth = 0.0;
    double slope_north = 0.0;
    double slope_east = 0.0;
  };
  [[nodiscard]] Surface At(const Eigen::Vector2d& p_W);

 private:
  static constexpr int kCells = 32;
  static constexpr int kNodes = kCells + 1;
  static constexpr double kSpacing = 0.25;  ///< between nodes [m]
  using Patch = std::vector<float>;

  const Patch& PatchAt(int north_index, int east_index);

  SeabedDepthFunction depth_;
  std::map<std::pair<int, int>, Patch> patches_;
  std::pair<int, int> last_index_{0, 0};
  const Patch* last_ = nullptr;
};

}  // namespace limpet
