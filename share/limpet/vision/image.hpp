// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limpet {

/// Somebody else's pixels: 8-bit BGR, row-major, no padding. Pixel (i, j) covers [i, i+1) x [j,
/// j+1) of the image plane, so its centre is at (i + 0.5, j + 0.5).
struct ImageView {
  const std::uint8_t* bgr = nullptr;
  int width_px = 0;
  int height_px = 0;

  [[nodiscard]] const std::uint8_t* pixel(int column, int row) const {
    return bgr + 3 * (static_cast<std::ptrdiff_t>(row) * width_px + column);
  }
};

/// An image that owns its pixels, laid out as ImageView says.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> bgr;

  [[nodiscard]] ImageView view() const { return {bgr.data(), width_px, height_px}; }
};

}  // namespace limpet
