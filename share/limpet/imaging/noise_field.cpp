// SPDX-License-Identifier: MIT
#include "limpet/imaging/noise_field.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"
#include "limpet/core/smooth_step.hpp"

namespace limpet {
namespace {

constexpr int kSide = SeabedGround::kSize;

}  // namespace

NoiseField::NoiseField(int first_cells, int octaves, Random& random, Form form, float decay)
    : values_(static_cast<std::size_t>(kSide) * kSide, 0.0F) {
  LIMPET_REQUIRE(first_cells << (octaves - 1) <= kSide, "cells finer than texels");
  float sum = 0.0F;
  float weight = 1.0F;
  for (int octave = 0; octave < octaves; ++octave, weight *= decay)
    sum += weight;
  weight = 1.0F / sum;
  for (int octave = 0; octave < octaves; ++octave, weight *= decay) {
    Add(first_cells << octave, weight, form, random);
  }
}

void NoiseField::Add(int cells, float weight, Form form, Random& random) {
  const int texels = kSide / cells;
  std::vector<float> draws(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
  for (float& draw : draws)
    draw = static_cast<float>(random.Uniform(-1.0, 1.0));
  std::vector<float> ease;
  for (int i = 0; i < texels; ++i) {
    ease.push_back(SmoothStep(static_cast<float>(i) / static_cast<float>(texels)));
  }
  std::vector<float> nodes(static_cast<std::size_t>(cells) + 1);
  for (int row = 0; row < kSide; ++row) {
    const int upper = row / texels;
    const int lower = (upper + 1) & (cells - 1);
    const float low = ease[static_cast<std::size_t>(row % texels)];
    for (int i = 0; i <= cells; ++i) {
      const int column = i & (cells - 1);
      const float above = draws[static_cast<std::size_t>(upper * cells + column)];
      const float below = draws[static_cast<std::size_t>(lower * cells + column)];
      nodes[static_cast<std::size_t>(i)] = above + low * (below - above);
    }
    float* out = &values_[static_cast<std::size_t>(row) * kSide];
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const float left = nodes[i];
      const float step = nodes[i + 1] - left;
      for (const float share : ease) {
        const float value = left + share * step;
        *out++ += weight * (form == Form::kSmooth ? value : 1.0F - 2.0F * std::abs(value));
      }
    }
  }
}

}  // namespace limpet
