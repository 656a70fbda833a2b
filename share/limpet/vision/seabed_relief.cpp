// SPDX-License-Identifier: MIT
#include "limpet/vision/seabed_relief.hpp"

#include <cmath>

namespace limpet {

const SeabedRelief::Patch& SeabedRelief::PatchAt(int north_index, int east_index) {
  const std::pair index(north_index, east_index);
  if (last_ != nullptr && last_index_ == index) {
    return *last_;
  }
  Patch& patch = patches_[index];
  if (patch.empty()) {
    patch.reserve(static_cast<std::size_t>(kNodes) * kNodes);
    for (int i = 0; i < kNodes; ++i) {
      for (int j = 0; j < kNodes; ++j) {
        patch.push_back(static_cast<float>(
            depth_({(north_index * kCells + i) * kSpacing, (east_index * kCells + j) * kSpacing})));
      }
    }
  }
  last_index_ = index;
  last_ = &patch;
  return patch;
}

SeabedRelief::Surface SeabedRelief::At(const Eigen::Vector2d& p_W) {
  const double n = p_W.x() / kSpacing;
  const double e = p_W.y() / kSpacing;
  const double cell_n = std::floor(n);
  const double cell_e = std::floor(e);
  const int patch_n = static_cast<int>(std::floor(cell_n / kCells));
  const int patch_e = static_cast<int>(std::floor(cell_e / kCells));
  const Patch& patch = PatchAt(patch_n, patch_e);
  const int i = static_cast<int>(cell_n) - patch_n * kCells;
  const int j = static_cast<int>(cell_e) - patch_e * kCells;
  const float* node = patch.data() + i * kNodes + j;
  const double fn = n - cell_n;
  const double fe = e - cell_e;
  const double near = node[0] + fe * (node[1] - node[0]);
  const double far = node[kNodes] + fe * (node[kNodes + 1] - node[kNodes]);
  const double west = node[kNodes] - node[0];
  const double slope_e =
      node[1] - node[0] + fn * (node[kNodes + 1] - node[kNodes] - node[1] + node[0]);
  const double slope_n = west + fe * (node[kNodes + 1] - node[1] - west);
  return {near + fn * (far - near), slope_n / kSpacing, slope_e / kSpacing};
}

}  // namespace limpet
