// SPDX-License-Identifier: MIT
#include "limpet/vision/seabed_texture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/random.hpp"
#include "limpet/core/smooth_step.hpp"

namespace limpet {
namespace {

constexpr int kSize = SeabedTexture::kSize;
using Field = std::vector<float>;

std::size_t At(int column, int row) {
  return (static_cast<std::size_t>(row & (kSize - 1)) << SeabedTexture::kSizeBits) +
         static_cast<std::size_t>(column & (kSize - 1));
}

/// Adds smooth noise with one random value per `cell` texels, a power of two.
void AddNoise(Field& field, int cell, float amplitude, Random& random) {
  const int nodes = kSize / cell;
  Field values(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes));
  std::ranges::generate(values, [&random, amplitude] {
    return amplitude * static_cast<float>(random.Uniform(-1.0, 1.0));
  });
  const auto node = [&values, nodes](int column, int row) {
    const int index = (row & (nodes - 1)) * nodes + (column & (nodes - 1));
    return values[static_cast<std::size_t>(index)];
  };
  const auto ease = [cell](int texel) {
    return SmoothStep(static_cast<float>(texel & (cell - 1)) / static_cast<float>(cell));
  };
  for (int row = 0; row < kSize; ++row) {
    const float low = ease(row);
    const int j = row / cell;
    for (int i = 0; i < nodes; ++i) {
      const float left = node(i, j) + low * (node(i, j + 1) - node(i, j));
      const float right = node(i + 1, j) + low * (node(i + 1, j + 1) - node(i + 1, j));
      for (int texel = 0; texel < cell; ++texel) {
        field[At(i * cell + texel, row)] += left + ease(texel) * (right - left);
      }
    }
  }
}

/// Ripples of sand, bent by the relief that is there already.
void AddRipples(Field& height, Random& random) {
  const int waves_across = 3 + static_cast<int>(random.Index(4));
  const int waves_along = 26 + static_cast<int>(random.Index(10));
  const float turn = 2.0F * std::numbers::pi_v<float> / static_cast<float>(kSize);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const float bend = 0.9F * height[At(column, row)];
      const float phase = turn * static_cast<float>(waves_across * column + waves_along * row);
      height[At(column, row)] += 0.35F * std::sin(phase + bend);
    }
  }
}

/// Pebbles and stones: lumpy domes that also change the brightness of what they cover.
void AddStones(Field& height, Field& albedo, Random& random) {
  constexpr int kStones = 1400;
  for (int stone = 0; stone < kStones; ++stone) {
    const double radius = 1.5 + 1.8 / (0.08 + random.Uniform(0.0, 1.0));
    const int column = static_cast<int>(random.Index(kSize));
    const int row = static_cast<int>(random.Index(kSize));
    const double squeeze = random.Uniform(0.6, 1.0);
    const double turn = random.Uniform(0.0, std::numbers::pi);
    const double lumps = random.Uniform(0.0, 6.0);
    const auto tone = static_cast<float>(random.Uniform(-0.22, 0.08));
    const int reach = static_cast<int>(std::ceil(1.3 * radius));
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double a = dx * std::cos(turn) + dy * std::sin(turn);
        const double b = (dy * std::cos(turn) - dx * std::sin(turn)) / squeeze;
        const double edge = radius * (1.0 + 0.16 * std::sin(3.0 * std::atan2(b, a) + lumps));
        const double inside = 1.0 - (a * a + b * b) / (edge * edge);
        if (inside > 0.0) {
          height[At(column + dx, row + dy)] +=
              static_cast<float>(0.35 * radius * std::sqrt(inside));
          albedo[At(column + dx, row + dy)] = tone;
        }
      }
    }
  }
}

}  // namespace

SeabedTexture::SeabedTexture(std::uint64_t seed)
    : texels_(static_cast<std::size_t>(kStride) * static_cast<std::size_t>(kStride)) {
  Random random(seed, "seabed texture");
  Field height(static_cast<std::size_t>(kSize) * kSize, 0.0F);
  Field albedo(height.size(), 0.0F);
  AddNoise(height, 128, 4.0F, random);
  AddRipples(height, random);
  AddNoise(height, 32, 1.2F, random);
  AddNoise(height, 8, 0.5F, random);
  AddNoise(height, 2, 0.30F, random);
  AddNoise(albedo, 256, 0.05F, random);
  AddNoise(albedo, 64, 0.04F, random);
  AddStones(height, albedo, random);
  AddNoise(albedo, 1, 0.03F, random);
  for (int row = 0; row < kStride; ++row) {
    for (int column = 0; column < kStride; ++column) {
      // Lit from the low right, softly.
      const float slope = 0.10F * (height[At(column + 1, row)] - height[At(column - 1, row)]) +
                          0.06F * (height[At(column, row + 1)] - height[At(column, row - 1)]);
      const float bright =
          0.55F + albedo[At(column, row)] + 0.8F * slope / (1.0F + std::abs(slope));
      texels_[static_cast<std::size_t>(row) * kStride + static_cast<std::size_t>(column)] =
          static_cast<std::uint8_t>(std::clamp(255.0F * bright, 0.0F, 255.0F));
    }
  }
}

}  // namespace limpet
