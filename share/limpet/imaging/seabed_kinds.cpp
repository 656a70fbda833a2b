// SPDX-License-Identifier: MIT
#include "limpet/imaging/seabed_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "limpet/core/random.hpp"
#include "limpet/imaging/tile_noise.hpp"

namespace limpet {
namespace {

using Color = SeabedGround::Color;
/// Share of a kind at a texel, 0 to 1.
using Cover = std::function<float(float column, float row)>;

constexpr int kSize = SeabedGround::kSize;
constexpr double kTexel = SeabedGround::kTexel;
constexpr double kTurn = 2.0 * std::numbers::pi;

Color Between(const Color& a, const Color& b, float share) { return a + share * (b - a); }

float Ramp(float x, float low, float high) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// Sums octaves of noise, each twice as fine and half as high.
class Octaves {
 public:
  Octaves(int first_cells, int count, Random& random) {
    for (int i = 0; i < count; ++i)
      octaves_.emplace_back(first_cells << i, kSize, random);
  }
  [[nodiscard]] float At(float column, float row) const {
    float sum = 0.0F;
    float share = 0.5F;
    for (const TileNoise& octave : octaves_) {
      sum += share * octave.At(column, row);
      share *= 0.5F;
    }
    return sum;
  }
  /// Sharp crests: rock.
  [[nodiscard]] float RidgesAt(float column, float row) const {
    float sum = 0.0F;
    float share = 0.5F;
    for (const TileNoise& octave : octaves_) {
      sum += share * (1.0F - 2.0F * std::abs(octave.At(column, row)));
      share *= 0.5F;
    }
    return sum;
  }

 private:
  std::vector<TileNoise> octaves_;
};

template <class Paint>
void ForEachTexel(const Paint& paint) {
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column)
      paint(column, row);
  }
}

/// Ripples 13 to 16 cm apart, bent and torn by slow noise, with what is light lying in the troughs.
void LaySand(SeabedGround& ground, Random& random) {
  const Octaves bend(4, 3, random);
  const Octaves strength(4, 2, random);
  const Octaves tint(8, 4, random);
  const TileNoise grain(2048, kSize, random);
  const TileNoise coarse(512, kSize, random);
  const double along = random.Uniform(0.0, kTurn);
  const auto waves_across = static_cast<float>(std::round(72.0 * std::cos(along)) * kTurn / kSize);
  const auto waves_along = static_cast<float>(std::round(72.0 * std::sin(along)) * kTurn / kSize);
  ForEachTexel([&](int column, int row) {
    const auto x = static_cast<float>(column);
    const auto y = static_cast<float>(row);
    const float phase = waves_across * x + waves_along * y + 16.0F * bend.At(x, y);
    const float crest = std::sin(phase + 0.55F * std::sin(phase));  // steeper on the lee side
    const float ripple = crest * Ramp(strength.At(x, y), -0.35F, 0.25F);
    const float dust = grain.At(x, y);
    const float grit = coarse.At(x, y);
    ground.height(column, row) = 0.0095F * ripple + 0.010F * bend.At(x, y) + 0.0006F * grit;
    const Color sand =
        Color(0.19F, 0.255F, 0.30F) * (1.0F + 0.45F * tint.At(x, y) + 0.13F * dust + 0.08F * grit);
    const float detritus = 0.5F * Ramp(-ripple + 0.35F * grit + 0.5F * tint.At(y, x), 0.30F, 1.0F);
    ground.set_color(column, row, Between(sand, Color(0.055F, 0.085F, 0.095F), detritus));
  });
}

struct Stone {
  double radius, squeeze, turn, lumps;  ///< [m], -, [rad], [rad]
  double flatness;                      ///< height over radius
  Color color;
};

/// A lumpy dome that lies on whatever is there; nothing where `cover` is none.
void LayStone(SeabedGround& ground, const Stone& stone, int column, int row) {
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
    const Stone stone{.radius = 0.007 + 0.034 * share * share * share * share,
                      .squeeze = random.Uniform(0.6, 1.0),
                      .turn = random.Uniform(0.0, kTurn),
                      .lumps = random.Uniform(0.0, kTurn),
                      .flatness = random.Uniform(0.45, 0.8),
                      .color = StoneColor(random)};
    const bool lies =
        random.Uniform(0.0, 1.0) < cover(static_cast<float>(column), static_cast<float>(row));
    if (lies) LayStone(ground, stone, column, row);
  }
}

/// Ridges and boulders with crusts of coralline pink, brown and green turf.
void LayRock(SeabedGround& ground, const Cover& cover, Random& random) {
  const Octaves form(8, 7, random);
  const Octaves pink(16, 4, random);
  const Octaves turf(16, 5, random);
  const Octaves tint(64, 4, random);
  for (int i = 0; i < 260; ++i) {
    const int column = static_cast<int>(random.Index(kSize));
    const int row = static_cast<int>(random.Index(kSize));
    const double share = random.Uniform(0.0, 1.0);
    const Stone boulder{.radius = 0.10 + 0.55 * share * share * share,
                        .squeeze = random.Uniform(0.55, 1.0),
                        .turn = random.Uniform(0.0, kTurn),
                        .lumps = random.Uniform(0.0, kTurn),
                        .flatness = random.Uniform(0.3, 0.6),
                        .color = Color(0.0F, 0.0F, 0.0F)};
    if (cover(static_cast<float>(column), static_cast<float>(row)) > 0.5F) {
      LayStone(ground, boulder, column, row);
    }
  }
  ForEachTexel([&](int column, int row) {
    const auto x = static_cast<float>(column);
    const auto y = static_cast<float>(row);
    const float share = cover(x, y);
    if (share <= 0.0F) return;
    const float ridges = form.RidgesAt(x, y);
    ground.height(column, row) += share * 0.11F * ridges;
    const float shade = 1.0F + 0.8F * tint.At(x, y);
    Color color = Color(0.085F, 0.105F, 0.115F) * shade;
    color = Between(color, Color(0.14F, 0.10F, 0.22F) * shade,
                    0.75F * Ramp(pink.At(x, y), 0.10F, 0.22F));
    // Turf takes what is in the light: crests.
    const float growth = turf.At(x, y) + 0.25F * ridges;
    color =
        Between(color, Color(0.018F, 0.050F, 0.055F) * shade, 0.85F * Ramp(growth, 0.10F, 0.25F));
    color = Between(color, Color(0.03F, 0.095F, 0.05F) * shade, 0.6F * Ramp(-growth, 0.18F, 0.35F));
    ground.set_color(column, row, Between(ground.color(column, row), color, share));
  });
}

/// One leaf as a curved stroke, dark at its foot.
void LayLeaf(SeabedGround& ground, double column, double row, double direction, Random& random) {
  const double length = random.Uniform(0.10, 0.38) / kTexel;
  const double curl = random.Uniform(-2.2, 2.2) / length;
  const double half_width = random.Uniform(0.5, 1.1);
  const auto bright = static_cast<float>(random.Uniform(0.6, 1.5));
  const auto age = static_cast<float>(std::pow(random.Uniform(0.0, 1.0), 3.0));
  const Color tip =
      Between(Color(0.030F, 0.135F, 0.060F), Color(0.05F, 0.10F, 0.12F), age) * bright;
  const Color foot = Color(0.008F, 0.024F, 0.014F);
  const float level = ground.height(static_cast<int>(column), static_cast<int>(row));
  for (double s = 0.0; s < length; s += 0.8) {
    const auto share = static_cast<float>(s / length);
    const Color color = Between(foot, tip, std::sqrt(share));
    const double across_x = -std::sin(direction);
    const double across_y = std::cos(direction);
    for (double w = -half_width; w <= half_width; w += 0.8) {
      const int x = static_cast<int>(std::floor(column + w * across_x));
      const int y = static_cast<int>(std::floor(row + w * across_y));
      ground.set_color(x, y, color * static_cast<float>(1.0 - 0.25 * w / half_width));
      ground.height(x, y) = level + 0.012F * share;
    }
    column += 0.8 * std::cos(direction);
    row += 0.8 * std::sin(direction);
    direction += 0.8 * curl;
  }
}

void LaySeagrass(SeabedGround& ground, const Cover& cover, Random& random) {
  const TileNoise sway(8, kSize, random);
  const double current = random.Uniform(0.0, kTurn);
  ForEachTexel([&](int column, int row) {
    const float share = 0.75F * cover(static_cast<float>(column), static_cast<float>(row));
    if (share <= 0.0F) return;
    ground.set_color(column, row,
                     Between(ground.color(column, row), Color(0.025F, 0.045F, 0.035F), share));
  });
  constexpr int kLeaves = 90000;
  for (int i = 0; i < kLeaves; ++i) {
    const double column = random.Uniform(0.0, kSize);
    const double row = random.Uniform(0.0, kSize);
    const bool grows =
        random.Uniform(0.0, 1.0) < cover(static_cast<float>(column), static_cast<float>(row));
    if (!grows) continue;
    const double bend = sway.At(static_cast<float>(column), static_cast<float>(row));
    LayLeaf(ground, column, row, current + 1.2 * bend + random.Normal(0.45), random);
  }
}

float Everywhere(float, float) { return 1.0F; }

}  // namespace

SeabedGround MakeSeabed(std::string_view kind, std::uint64_t seed) {
  Random random(seed, "seabed ground");
  SeabedGround ground;
  LaySand(ground, random);
  const Octaves banks(4, 5, random);
  const Octaves meadows(4, 5, random);
  const auto where = [](const Octaves& noise, float from) {
    return [&noise, from](float column, float row) {
      return Ramp(noise.At(column, row), from, from + 0.08F);
    };
  };
  if (kind == "gravel") {
    LayGravel(ground, Everywhere, random);
  } else if (kind == "rock") {
    LayRock(ground, Everywhere, random);
  } else if (kind == "seagrass") {
    LaySeagrass(ground, where(meadows, -0.16F), random);
  } else if (kind == "mixed") {
    LayGravel(ground, where(banks, 0.02F), random);
    LayRock(ground, where(banks, 0.16F), random);
    LaySeagrass(ground, where(meadows, 0.13F), random);
  } else {
    // Sand has shells and a few stones, too.
    LayGravel(
        ground, [](float, float) { return 0.004F; }, random);
  }
  return ground;
}

}  // namespace limpet
