// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/core/smooth_step.hpp"

namespace limpet {

/// Smooth noise in -1 .. 1 over a square that repeats without a seam; one draw per cell.
class TileNoise {
 public:
  /// `cells` per side; `side`: in whatever unit places are given. REQUIRES: cells a power of two.
  TileNoise(int cells, double side, Random& random)
      : mask_(cells - 1), cells_per_unit_(static_cast<float>(cells / side)) {
    values_.resize(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (float& value : values_)
      value = static_cast<float>(random.Uniform(-1.0, 1.0));
  }

  /// REQUIRES: places within 32 000 cells of the corner.
  [[nodiscard]] float At(float across, float along) const {
    const float x = across * cells_per_unit_;
    const float y = along * cells_per_unit_;
    // Conversion to int is far cheaper than std::floor; the offset keeps it from rounding upwards.
    constexpr int kOffset = 1 << 16;
    const int column = static_cast<int>(x + kOffset) - kOffset;
    const int row = static_cast<int>(y + kOffset) - kOffset;
    const float right = SmoothStep(x - static_cast<float>(column));
    const float low = SmoothStep(y - static_cast<float>(row));
    const float above = Value(column, row) + right * (Value(column + 1, row) - Value(column, row));
    const float below =
        Value(column, row + 1) + right * (Value(column + 1, row + 1) - Value(column, row + 1));
    return above + low * (below - above);
  }

 private:
  [[nodiscard]] float Value(int column, int row) const {
    return values_[static_cast<std::size_t>((row & mask_) * (mask_ + 1) + (column & mask_))];
  }
  int mask_;
  float cells_per_unit_;
  std::vector<float> values_;
};

}  // namespace limpet
