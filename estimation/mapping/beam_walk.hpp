// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <Eigen/Core>

namespace limpet {

using VoxelIndex = std::array<std::int32_t, 3>;

/// A beam's way from voxel to voxel [Amanatides 1987]. The number of steps follows from both ends'
/// voxels alone, so it always arrives, however the crossings round.
class BeamWalk {
 public:
  /// Both ends in voxels along the axes of W.
  BeamWalk(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const double first = std::floor(from_W[i]);
      const double off = to_W[i] - from_W[i];
      at_[axis] = static_cast<std::int32_t>(first);
      const std::int32_t way = static_cast<std::int32_t>(std::floor(to_W[i])) - at_[axis];
      left_[axis] = std::abs(way);
      steps_ += left_[axis];
      step_[axis] = way < 0 ? -1 : 1;
      if (way != 0) {
        per_voxel_[axis] = 1.0 / std::abs(off);
        crossing_[axis] = ((way > 0 ? first + 1.0 : first) - from_W[i]) / off;
      }
    }
  }
  [[nodiscard]] const VoxelIndex& at() const { return at_; }
  [[nodiscard]] bool HasArrived() const { return steps_ == 0; }
  void Step() {
    const std::size_t nearer = crossing_[0] <= crossing_[1] ? 0 : 1;
    const std::size_t axis = crossing_[nearer] <= crossing_[2] ? nearer : 2;
    at_[axis] += step_[axis];
    crossing_[axis] = --left_[axis] > 0 ? crossing_[axis] + per_voxel_[axis] : kNever;
    --steps_;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  VoxelIndex at_{}, left_{}, step_{};
  std::int32_t steps_ = 0;
  /// Shares of the beam: where it next leaves its voxel along an axis, and what a voxel takes.
  std::array<double, 3> crossing_{kNever, kNever, kNever}, per_voxel_{};
};

}  // namespace limpet
