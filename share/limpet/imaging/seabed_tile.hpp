// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limpet {

/// A square of seabed that repeats without a seam: what it returns of light, its small forms'
/// shades included, at several resolutions, so that what is far away does not flicker.
class SeabedTile {
 public:
  static constexpr int kSize = 2048;  ///< texels per side at full resolution
  static constexpr double kTexelsPerMeter = 200.0;
  static constexpr int kLevels = 5;

  /// `albedo`: linear blue, green, red, 0 to 1, row-major kSize x kSize; columns to the east, rows
  /// to the north.
  explicit SeabedTile(const std::vector<std::array<float, 3>>& albedo);

  /// Texels hold square roots of blue, green, red albedo in 1/255, packed from the lowest byte on.
  /// Places count in 1/kUnitsPerTexel texel of full resolution.
  static constexpr int kUnitsPerTexel = 4096;

  /// Where a texel of a level of 1 << bits texels per side is stored: 4 x 4 of them together fill a
  /// line of the cache, so that walks in any direction find their neighbours there.
  [[nodiscard]] static std::size_t Place(std::int32_t column, std::int32_t row, int bits) {
    return static_cast<std::size_t>(((row & ~3) << bits) | ((column & ~3) << 2) | ((row & 3) << 2) |
                                    (column & 3));
  }

  /// One resolution, read at the nearest texel: for pixels as large as its texels. `index` 0 is
  /// full resolution, every further one half of that.
  class Level {
   public:
    Level(const std::uint32_t* texels, int index)
        : texels_(texels),
          shift_(kUnitBits + index),
          bits_(kSizeBits - index),
          mask_((1 << bits_) - 1) {}
    [[nodiscard]] std::uint32_t At(std::int32_t across, std::int32_t along) const {
      return texels_[Place((across >> shift_) & mask_, (along >> shift_) & mask_, bits_)];
    }

   private:
    const std::uint32_t* texels_;
    int shift_, bits_, mask_;
  };
  /// REQUIRES: 0 <= index < kLevels.
  [[nodiscard]] Level level(int index) const {
    return {levels_[static_cast<std::size_t>(index)].data(), index};
  }

  /// Between texels of full resolution, bilinear: for pixels smaller than they are.
  [[nodiscard]] std::uint32_t Between(std::int32_t across, std::int32_t along) const {
    constexpr int kMask = kSize - 1;
    // Texels' values belong to their middles.
    const std::int32_t u = (across - kUnitsPerTexel / 2) >> (kUnitBits - 8);
    const std::int32_t v = (along - kUnitsPerTexel / 2) >> (kUnitBits - 8);
    const std::int32_t column = (u >> 8) & kMask;
    const std::int32_t next_column = (column + 1) & kMask;
    const std::int32_t row = (v >> 8) & kMask;
    const std::int32_t next_row = (row + 1) & kMask;
    const auto at = [this](std::int32_t x, std::int32_t y) {
      return levels_[0][Place(x, y, kSizeBits)];
    };
    const auto right = static_cast<std::uint32_t>(u & 255);
    return Mix(Mix(at(column, row), at(next_column, row), right),
               Mix(at(column, next_row), at(next_column, next_row), right),
               static_cast<std::uint32_t>(v & 255));
  }

 private:
  static constexpr int kUnitBits = 12;
  static constexpr int kSizeBits = 11;
  static_assert(kUnitsPerTexel == 1 << kUnitBits);
  static_assert(kSize == 1 << kSizeBits);
  /// Two bytes at a time, `share` in 1/256 of `b`.
  [[nodiscard]] static std::uint32_t Mix(std::uint32_t a, std::uint32_t b, std::uint32_t share) {
    constexpr std::uint32_t kEven = 0x00ff00ffU;
    const std::uint32_t even = ((a & kEven) * (256U - share) + (b & kEven) * share) >> 8U;
    const std::uint32_t odd = ((a >> 8U) & kEven) * (256U - share) + ((b >> 8U) & kEven) * share;
    return (even & kEven) | (odd & ~kEven);
  }
  std::array<std::vector<std::uint32_t>, kLevels> levels_;
};

}  // namespace limpet
