// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limpet {

/// A tile of sand with ripples, pebbles and stones, lit from one side; it repeats without a seam.
class SeabedTexture {
 public:
  static constexpr int kSizeBits = 10;
  static constexpr int kSize = 1 << kSizeBits;  ///< texels per side
  static constexpr double kTexelsPerMeter = 100.0;

  explicit SeabedTexture(std::uint64_t seed);

  /// Brightness 0 to 255 at a place in 1/256 texel, bilinear.
  [[nodiscard]] int Sample(std::int32_t across_q8, std::int32_t along_q8) const {
    const int column = (across_q8 >> 8) & (kSize - 1);
    const int row = (along_q8 >> 8) & (kSize - 1);
    const int right = across_q8 & 255;
    const int low = along_q8 & 255;
    const std::uint8_t* texel =
        texels_.data() + static_cast<std::ptrdiff_t>(row) * kStride + column;
    const int upper = texel[0] * (256 - right) + texel[1] * right;
    const int lower = texel[kStride] * (256 - right) + texel[kStride + 1] * right;
    return (upper * (256 - low) + lower * low) >> 16;
  }
  /// Linear blue, green, red (0 to 4095) of a brightness b: (kTone[c][0] + kTone[c][1] b) b.
  /// Dark is greyish green stone, bright is warm sand.
  static constexpr std::array<std::array<float, 2>, 3> kTone{
      {{2.6F, 0.0156F}, {3.0F, 0.0218F}, {2.6F, 0.0250F}}};

 private:
  static constexpr int kStride = kSize + 1;  ///< one texel more, so that a sample needs no wrap
  std::vector<std::uint8_t> texels_;
};

}  // namespace limpet
