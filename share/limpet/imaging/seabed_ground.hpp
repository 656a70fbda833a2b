// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "limpet/imaging/seabed_tile.hpp"

namespace limpet {

/// A tile of seabed in the making: form and colour, before light falls on it. Indices wrap.
class SeabedGround {
 public:
  static constexpr int kSize = SeabedTile::kSize;
  static constexpr double kTexel = 1.0 / SeabedTile::kTexelsPerMeter;  ///< [m]
  using Color = Eigen::Array3f;  ///< linear blue, green, red, 0 to 1

  SeabedGround();
  [[nodiscard]] static std::size_t Index(int column, int row) {
    constexpr int kMask = kSize - 1;
    return static_cast<std::size_t>(row & kMask) * kSize + static_cast<std::size_t>(column & kMask);
  }
  [[nodiscard]] float& height(int column, int row) { return height_[Index(column, row)]; }  ///< [m]
  [[nodiscard]] Color color(int column, int row) const {
    const auto& color = color_[Index(column, row)];
    return {color[0], color[1], color[2]};
  }
  void set_color(int column, int row, const Color& color) {
    color_[Index(column, row)] = {color(0), color(1), color(2)};
  }

  /// What the tile returns under a sun at `towards_sun_W` (east, north, up; unit vector): slopes
  /// that face it are brighter, hollows get less of the sky. `steepness` scales slopes.
  [[nodiscard]] SeabedTile Lit(const Eigen::Vector3d& towards_sun_W, double steepness) const;

 private:
  [[nodiscard]] std::vector<float> SmoothHeight(int radius) const;
  std::vector<float> height_;
  std::vector<std::array<float, 3>> color_;
};

}  // namespace limpet
