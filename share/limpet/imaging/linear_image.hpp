// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace limpet {

/// Linear light of a whole picture: blue, green, red planes. 1 is what a white surface returns that
/// the sun of a clear noon lights just below the water's surface.
struct LinearImage {
  int width_px = 0;
  int height_px = 0;
  std::size_t stride = 0;  ///< floats from row to row
  std::array<std::vector<float>, 3> planes;

  LinearImage() = default;
  LinearImage(int width, int height, std::size_t row_stride)
      : width_px(width), height_px(height), stride(row_stride) {
    planes.fill(std::vector<float>(row_stride * static_cast<std::size_t>(height)));
  }
  [[nodiscard]] float* row(std::size_t channel, int index) {
    return planes[channel].data() + stride * static_cast<std::size_t>(index);
  }
  [[nodiscard]] const float* row(std::size_t channel, int index) const {
    return planes[channel].data() + stride * static_cast<std::size_t>(index);
  }
};

}  // namespace limpet
