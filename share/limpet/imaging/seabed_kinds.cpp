// SPDX-License-Identifier: MIT
#include "limpet/imaging/seabed_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "limpet/core/random.hpp"
#include "limpet/core/smooth_step.hpp"
#include "limpet/imaging/noise_field.hpp"

namespace limpet {
namespace {

using Color = SeabedGround::Color;
constexpr int kSize = SeabedGround::kSize;
constexpr double kTexel = SeabedGround::kTexel;
constexpr double kTurn = 2.0 * std::numbers::pi;

Color Between(const Color& a, const Color& b, float share) { return a + share * (b - a); }

float Ramp(float x, float low, float high) {
  return SmoothStep(std::clamp((x - low) / (high - low), 0.0F, 1.0F));
}

/// Share of the ground that a kind takes, 0 to 1: where slow noise is high, or one share all over.
struct Cover {
  const NoiseField* noise = nullptr;
  float from = 0.0F;  ///< of the noise; without noise the share

  [[nodiscard]] float At(int column, int row) const {
    return noise == nullptr ? from : Ramp(noise->At(column, row), from, from + 0.08F);
  }
};

/// White noise in -1 .. 1.
float Grain(int column, int row) {
  auto bits = static_cast<std::uint32_t>(row * kSize + column) * 0x9e3779b9U;
  bits = (bits ^ (bits >> 15U)) * 0x85ebca6bU;
  bits = (bits ^ (bits >> 13U)) * 0xc2b2ae35U;
  return static_cast<float>(bits >> 8U) / 8388608.0F - 1.0F;
}

template <class Paint>
void ForEachTexel(const Paint& paint) {
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column)
      paint(column, row);
  }
}

/// Ripples 13 to 16 cm apart, bent and torn by slow noise, with what is light lying in the troughs.
void LaySand(SeabedGround& ground, Random& random) {
  const NoiseField bend(4, 4, random);
  const NoiseField strength(4, 3, random);
  const NoiseField tint(8, 6, random);
  const NoiseField grit(512, 2, random);
  const double along = random.Uniform(0.0, kTurn);
  const auto waves_across = static_cast<float>(std::round(72.0 * std::cos(along)) * kTurn / kSize);
  const auto waves_along = static_cast<float>(std::round(72.0 * std::sin(along)) * kTurn / kSize);
  ForEachTexel([&](int column, int row) {
    const float bent = bend.At(column, row);
    const float phase = waves_across * static_cast<float>(column) +
                        waves_along * static_cast<float>(row) + 15.0F * bent;
    const float crest = std::sin(phase + 0.55F * std::sin(phase));  // steeper on the lee side
    const float ripple = crest * Ramp(strength.At(column, row), -0.45F, 0.15F);
    const float rough = grit.At(column, row);
    const float shade = tint.At(column, row);
    ground.height(column, row) = 0.010F * ripple + 0.020F * bent + 0.0010F * rough;
    const Color sand = Color(0.19F, 0.255F, 0.30F) *
                       (1.0F + 0.5F * shade + 0.13F * Grain(column, row) + 0.12F * rough);
    const float detritus = 0.55F * Ramp(-ripple + 0.5F * rough + 0.8F * shade, 0.25F, 1.0F);
    ground.set_color(column, row, Between(sand, Color(0.055F, 0.085F, 0.095F), detritus));
  });
}

struct LaidStone {
  double radius, squeeze, turn, lumps;  ///< [m], -, [rad], [rad]
  double flatness;                      ///< height over radius
  Color color;
};

/// A lumpy dome that lies on whatever is there; nothing where `cover` is none.
void LayStone(SeabedGround& ground, const LaidStone& stone, int column, int row) {
  const double radius = stone.radius / kTexel;
  const int reach = static_cast<int>(std::ceil(1.3 * radius));
  const double cosine = std::cos(stone.turn);
  const double sine = std::sin(stone.turn);
  const float base = ground.height(column, row) - 0.2F * static_cast<float>(stone.radius);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double a = dx * cosine + dy * sine;
      const double b = (dy * cosine - dx * sine) / stone.squeeze;
      const double far2 = a * a + b * b;
      if (far2 > 1.7 * radius * radius) continue;
      // The outline's lumps without an angle: a cubic of the place, which has three lobes.
      const double lobes =
          radius > 2.0 ? a * (a * a - 3.0 * b * b) / (far2 * std::sqrt(far2) + 1e-6) : 0.0;
      const double edge =
          radius * (1.0 + 0.15 * lobes * std::cos(stone.lumps) + 0.06 * std::sin(stone.lumps));
      const double inside = 1.0 - far2 / (edge * edge);
      if (inside <= 0.0) continue;
      const float top =
          base + static_cast<float>(stone.flatness * stone.radius * std::sqrt(inside));
      float& height = ground.height(column + dx, row + dy);
      if (top <= height) continue;
      height = top;
      ground.set_color(column + dx, row + dy, stone.color);
    }
  }
}

Color StoneColor(Random& random) {
  const auto bright = static_cast<float>(0.05 + 0.22 * std::pow(random.Uniform(0.0, 1.0), 2.0));
  const auto warm = static_cast<float>(random.Uniform(-0.12, 0.22));
  return {bright * (1.0F - warm), bright, bright * (1.05F + warm)};
}

void LayGravel(SeabedGround& ground, const Cover& cover, Random& random) {
  constexpr int kStones = 150000;
  for (int i = 0; i < kStones; ++i) {
    const int column = static_cast<int>(random.Index(kSize));
    const int row = static_cast<int>(random.Index(kSize));
    const double share = random.Uniform(0.0, 1.0);
    const LaidStone stone{.radius = 0.007 + 0.034 * share * share * share * share,
                          .squeeze = random.Uniform(0.6, 1.0),
                          .turn = random.Uniform(0.0, kTurn),
                          .lumps = random.Uniform(0.0, kTurn),
                          .flatness = random.Uniform(0.45, 0.8),
                          .color = StoneColor(random)};
    const bool lies = random.Uniform(0.0, 1.0) < cover.At(column, row);
    if (lies) LayStone(ground, stone, column, row);
  }
}

/// Boulders of all sizes under a rough skin.
void LayBoulders(SeabedGround& ground, const Cover& cover, Random& random) {
  constexpr int kBoulders = 700;
  for (int i = 0; i < kBoulders; ++i) {
    const int column = static_cast<int>(random.Index(kSize));
    const int row = static_cast<int>(random.Index(kSize));
    const double share = random.Uniform(0.0, 1.0);
    const LaidStone boulder{.radius = 0.06 + 0.55 * share * share * share,
                            .squeeze = random.Uniform(0.55, 1.0),
                            .turn = random.Uniform(0.0, kTurn),
                            .lumps = random.Uniform(0.0, kTurn),
                            .flatness = random.Uniform(0.35, 0.7),
                            .color = Color(0.0F, 0.0F, 0.0F)};
    if (cover.At(column, row) > 0.5F) LayStone(ground, boulder, column, row);
  }
}

/// Rock with crusts of coralline pink, brown and green turf.
void LayRock(SeabedGround& ground, const Cover& cover, Random& random) {
  const NoiseField form(8, 7, random, NoiseField::Form::kRidged, 0.55F);
  const NoiseField pink(16, 6, random, NoiseField::Form::kSmooth, 0.65F);
  const NoiseField turf(16, 7, random, NoiseField::Form::kSmooth, 0.7F);
  const NoiseField tint(64, 5, random, NoiseField::Form::kSmooth, 0.8F);
  const NoiseField cracks(16, 2, random, NoiseField::Form::kRidged, 0.3F);
  SeabedGround boulders;
  LayBoulders(boulders, cover, random);
  ForEachTexel([&](int column, int row) {
    const float share = cover.At(column, row);
    if (share <= 0.0F) return;
    const float ridges = form.At(column, row);
    float& height = ground.height(column, row);
    height = (1.0F - share) * height + share * (boulders.height(column, row) + 0.34F * ridges);
    const float crack = Ramp(cracks.At(column, row), 0.80F, 0.97F);
    const float shade =
        (1.0F + 0.95F * tint.At(column, row) + 0.14F * Grain(column, row)) * (1.0F - 0.75F * crack);
    Color color = Color(0.12F, 0.145F, 0.16F) * shade;
    const float crust = Ramp(pink.At(column, row), 0.10F, 0.20F);
    color = Between(color, Color(0.17F, 0.12F, 0.26F) * shade, 0.7F * crust);
    // Turf takes what is in the light: crests.
    const float growth = turf.At(column, row) + 0.25F * ridges;
    color =
        Between(color, Color(0.018F, 0.050F, 0.055F) * shade, 0.8F * Ramp(growth, 0.08F, 0.20F));
    color = Between(color, Color(0.03F, 0.095F, 0.05F) * shade, 0.6F * Ramp(-growth, 0.14F, 0.28F));
    ground.set_color(column, row, Between(ground.color(column, row), color, share));
  });
}

/// Where a leaf is drawn, and which way it goes on [rad].
struct LeafPoint {
  double column, row, direction;
};

/// One leaf as a curved stroke from its foot, which is dark.
void LayLeaf(SeabedGround& ground, LeafPoint at, Random& random) {
  const double length = random.Uniform(0.10, 0.38) / kTexel;
  const double curl = random.Uniform(-2.2, 2.2) / length;
  const double half_width = random.Uniform(0.5, 1.1);
  const auto bright = static_cast<float>(random.Uniform(0.6, 1.5));
  const auto age = static_cast<float>(std::pow(random.Uniform(0.0, 1.0), 3.0));
  const Color tip =
      Between(Color(0.030F, 0.135F, 0.060F), Color(0.05F, 0.10F, 0.12F), age) * bright;
  const Color foot = Color(0.008F, 0.024F, 0.014F);
  const float level = ground.height(static_cast<int>(at.column), static_cast<int>(at.row));
  for (double s = 0.0; s < length; s += 0.8) {
    const auto share = static_cast<float>(s / length);
    const Color color = Between(foot, tip, std::sqrt(share));
    const double across_x = -std::sin(at.direction);
    const double across_y = std::cos(at.direction);
    for (double w = -half_width; w <= half_width; w += 0.8) {
      const int x = static_cast<int>(std::floor(at.column + w * across_x));
      const int y = static_cast<int>(std::floor(at.row + w * across_y));
      ground.set_color(x, y, color * static_cast<float>(1.0 - 0.25 * w / half_width));
      ground.height(x, y) = level + 0.012F * share;
    }
    at.column += 0.8 * std::cos(at.direction);
    at.row += 0.8 * std::sin(at.direction);
    at.direction += 0.8 * curl;
  }
}

void LaySeagrass(SeabedGround& ground, const Cover& cover, Random& random) {
  const NoiseField sway(8, 2, random);
  const double current = random.Uniform(0.0, kTurn);
  ForEachTexel([&](int column, int row) {
    const float share = 0.75F * cover.At(column, row);
    if (share <= 0.0F) return;
    const Color litter(0.025F, 0.045F, 0.035F);
    ground.set_color(column, row, Between(ground.color(column, row), litter, share));
  });
  constexpr int kLeaves = 90000;
  for (int i = 0; i < kLeaves; ++i) {
    const int column = static_cast<int>(random.Index(kSize));
    const int row = static_cast<int>(random.Index(kSize));
    if (random.Uniform(0.0, 1.0) >= cover.At(column, row)) continue;
    const double direction = current + 1.2 * sway.At(column, row) + random.Normal(0.45);
    LayLeaf(ground, {column + 0.5, row + 0.5, direction}, random);
  }
}

}  // namespace

SeabedGround MakeSeabed(std::string_view kind, std::uint64_t seed) {
  Random random(seed, "seabed ground");
  SeabedGround ground;
  LaySand(ground, random);
  const Cover everywhere{.noise = nullptr, .from = 1.0F};
  if (kind == "gravel") {
    LayGravel(ground, everywhere, random);
  } else if (kind == "rock") {
    LayRock(ground, everywhere, random);
  } else if (kind == "seagrass") {
    const NoiseField meadows(4, 5, random);
    LaySeagrass(ground, {&meadows, -0.16F}, random);
  } else if (kind == "mixed") {
    const NoiseField banks(4, 5, random);
    const NoiseField meadows(4, 5, random);
    LayGravel(ground, {&banks, 0.04F}, random);
    LayRock(ground, {&banks, 0.20F}, random);
    LaySeagrass(ground, {&meadows, 0.17F}, random);
  } else {
    // Sand has shells and a few stones, too.
    LayGravel(ground, {.noise = nullptr, .from = 0.004F}, random);
  }
  return ground;
}

}  // namespace limpet
