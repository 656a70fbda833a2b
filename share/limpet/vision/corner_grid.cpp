// SPDX-License-Identifier: MIT
#include "limpet/vision/corner_grid.hpp"

namespace limpet {
namespace {

std::size_t CornersOver(int pixels) {
  constexpr int kBlock = CornerGrid::kBlock;
  return static_cast<std::size_t>((pixels + kBlock - 1) / kBlock + 1);
}

}  // namespace

CornerGrid::CornerGrid(const CameraModel& camera, std::size_t layers)
    : columns_(CornersOver(camera.width_px)),
      rows_(CornersOver(camera.height_px)),
      layers_(layers),
      nodes_(columns_ * rows_ * layers),
      places_(columns_ * rows_),
      row_(columns_ * layers) {}

void CornerGrid::TakeRow(int row) {
  const auto upper = static_cast<std::size_t>(row / kBlock) * layers_ * columns_;
  const float low = (static_cast<float>(row % kBlock) + 0.5F) / kBlock;
  const float* above = &nodes_[upper];
  const float* below = above + layers_ * columns_;
  for (std::size_t i = 0; i < row_.size(); ++i) {
    row_[i] = above[i] + low * (below[i] - above[i]);
  }
}

}  // namespace limpet
