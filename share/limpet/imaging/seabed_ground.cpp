// SPDX-License-Identifier: MIT
#include "limpet/imaging/seabed_ground.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {

SeabedGround::SeabedGround()
    : height_(static_cast<std::size_t>(kSize) * kSize, 0.0F),
      color_(height_.size(), {0.0F, 0.0F, 0.0F}) {}

/// Mean over squares of 2 radius + 1 texels, rows then columns, by running sums.
std::vector<float> SeabedGround::SmoothHeight(int radius) const {
  const float share = 1.0F / static_cast<float>(2 * radius + 1);
  std::vector<float> rows(height_.size());
  std::vector<float> both(height_.size());
  for (int row = 0; row < kSize; ++row) {
    double sum = 0.0;
    for (int i = -radius; i < radius; ++i)
      sum += height_[Index(i, row)];
    for (int column = 0; column < kSize; ++column) {
      sum += height_[Index(column + radius, row)];
      rows[Index(column, row)] = share * static_cast<float>(sum);
      sum -= height_[Index(column - radius, row)];
    }
  }
  std::vector<double> sums(kSize, 0.0);  // of all columns at once: memory is read in order
  for (int row = -radius; row < kSize + radius; ++row) {
    for (int column = 0; column < kSize; ++column) {
      double& sum = sums[static_cast<std::size_t>(column)];
      sum += rows[Index(column, row)];
      if (row >= radius) {
        both[Index(column, row - radius)] = share * static_cast<float>(sum);
        sum -= rows[Index(column, row - 2 * radius)];
      }
    }
  }
  return both;
}

SeabedTile SeabedGround::Lit(const Eigen::Vector3d& towards_sun_W, double steepness) const {
  constexpr float kSky = 0.42F;          // share of light that comes from everywhere
  constexpr float kHollow_per_m = 8.0F;  // light that a hollow lacks, per metre below its rim
  const std::vector<float> rim = SmoothHeight(12);
  const Eigen::Vector3f sun = towards_sun_W.cast<float>();
  const auto scale = static_cast<float>(steepness * 0.5 / kTexel);
  std::vector<std::array<float, 3>> albedo(color_.size());
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const std::size_t i = Index(column, row);
      const float east =
          scale * (height_[Index(column + 1, row)] - height_[Index(column - 1, row)]);
      const float north =
          scale * (height_[Index(column, row + 1)] - height_[Index(column, row - 1)]);
      const float facing = (sun.z() - east * sun.x() - north * sun.y()) /
                           std::sqrt(1.0F + east * east + north * north);
      const float hollow =
          std::clamp(1.0F - static_cast<float>(steepness) * kHollow_per_m * (rim[i] - height_[i]),
                     0.35F, 1.15F);
      const float light = hollow * (kSky + (1.0F - kSky) * std::max(facing, 0.0F) / sun.z());
      for (std::size_t c = 0; c < 3; ++c)
        albedo[i][c] = light * color_[i][c];
    }
  }
  return SeabedTile(albedo);
}

}  // namespace limpet
