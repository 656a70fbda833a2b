// SPDX-License-Identifier: MIT
#include "limpet/imaging/seabed_tile.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using AlbedoField = std::vector<std::array<float, 3>>;

std::vector<std::uint32_t> Packed(const AlbedoField& albedo, int bits) {
  std::vector<std::uint32_t> texels(albedo.size());
  const int side = 1 << bits;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const auto& color = albedo[static_cast<std::size_t>((row << bits) + column)];
      std::uint32_t packed = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const float root = std::sqrt(std::clamp(color[c], 0.0F, 1.0F));
        packed |= static_cast<std::uint32_t>(std::lround(255.0F * root)) << (8U * c);
      }
      texels[SeabedTile::Place(column, row, bits)] = packed;
    }
  }
  return texels;
}

AlbedoField Halved(const AlbedoField& albedo, std::size_t side) {
  AlbedoField half(albedo.size() / 4);
  for (std::size_t row = 0; row < side / 2; ++row) {
    for (std::size_t column = 0; column < side / 2; ++column) {
      const std::size_t i = 2 * row * side + 2 * column;
      for (std::size_t c = 0; c < 3; ++c) {
        half[row * (side / 2) + column][c] =
            0.25F *
            (albedo[i][c] + albedo[i + 1][c] + albedo[i + side][c] + albedo[i + side + 1][c]);
      }
    }
  }
  return half;
}

}  // namespace

SeabedTile::SeabedTile(const AlbedoField& albedo) {
  LIMPET_REQUIRE(albedo.size() == static_cast<std::size_t>(kSize) * kSize, "a tile of one size");
  levels_[0] = Packed(albedo, kSizeBits);
  AlbedoField coarser = albedo;
  for (std::size_t level = 1; level < kLevels; ++level) {
    coarser = Halved(coarser, static_cast<std::size_t>(kSize) >> (level - 1));
    levels_[level] = Packed(coarser, kSizeBits - static_cast<int>(level));
  }
}

}  // namespace limpet
