// SPDX-License-Identifier: MIT
#include "limpet/imaging/caustics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

struct Wave {
  double across, along;  ///< [rad/texel]
  double slope, phase;
};

std::vector<Wave> WavesOf(Random& random, int size) {
  std::vector<Wave> waves;
  for (int i = 0; i < 24; ++i) {
    const double turn = random.Uniform(0.0, 2.0 * std::numbers::pi);
    const double count = random.Uniform(2.0, 9.0);
    const double across = std::round(count * std::cos(turn));
    const double along = std::round(count * std::sin(turn));
    const double per_texel = 2.0 * std::numbers::pi / size;
    // Shorter waves are lower; what bends light is their slope.
    waves.push_back({across * per_texel, along * per_texel, 1.0 / (1.0 + 0.25 * count),
                     random.Uniform(0.0, 2.0 * std::numbers::pi)});
  }
  return waves;
}

/// Where the ray that would land at (x, y) [texel] is bent to.
Eigen::Vector2d Landing(const std::vector<Wave>& waves, double x, double y) {
  // Slope times a quarter of the way to the focus of most waves [texel].
  constexpr double kThrow = 5.5;
  Eigen::Vector2d landed(x, y);
  for (const Wave& wave : waves) {
    const double length = std::hypot(wave.across, wave.along) + 1e-9;
    const double bend =
        kThrow * wave.slope * std::cos(wave.across * x + wave.along * y + wave.phase);
    landed.x() += bend * wave.across / length;
    landed.y() += bend * wave.along / length;
  }
  return landed;
}

/// Counts rays where they land; the tile repeats.
void CountRays(const std::vector<Wave>& waves, int size, std::vector<float>& tile) {
  constexpr int kRays = 2;  // per texel and axis
  for (int row = 0; row < kRays * size; ++row) {
    for (int column = 0; column < kRays * size; ++column) {
      const Eigen::Vector2d landed = Landing(waves, (column + 0.5) / kRays, (row + 0.5) / kRays);
      const int i = static_cast<int>(std::floor(landed.x())) & (size - 1);
      const int j = static_cast<int>(std::floor(landed.y())) & (size - 1);
      tile[static_cast<std::size_t>(j * size + i)] += 1.0F;
    }
  }
}

/// The sun is half a degree wide: lines are soft.
void Soften(int size, std::vector<float>& tile) {
  const std::vector<float> sharp = tile;
  const auto at = [&sharp, size](int i, int j) {
    return sharp[static_cast<std::size_t>((j & (size - 1)) * size + (i & (size - 1)))];
  };
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      tile[static_cast<std::size_t>(row * size + column)] =
          0.25F * at(column, row) +
          0.125F * (at(column - 1, row) + at(column + 1, row) + at(column, row - 1) +
                    at(column, row + 1)) +
          0.0625F * (at(column - 1, row - 1) + at(column + 1, row - 1) + at(column - 1, row + 1) +
                     at(column + 1, row + 1));
    }
  }
}

/// Shifts and scales the tile's values to mean 0 and standard deviation 1.
void Standardize(std::vector<float>& tile) {
  double sum = 0.0;
  double sum2 = 0.0;
  for (const float value : tile) {
    sum += static_cast<double>(value);
    sum2 += static_cast<double>(value) * static_cast<double>(value);
  }
  const auto count = static_cast<double>(tile.size());
  const double mean = sum / count;
  const double sigma = std::sqrt(std::max(sum2 / count - mean * mean, 1e-12));
  for (float& value : tile)
    value = static_cast<float>((static_cast<double>(value) - mean) / sigma);
}

}  // namespace

Caustics::Caustics(double contrast, std::uint64_t seed)
    : contrast_(contrast), tile_(static_cast<std::size_t>(kSize) * kSize, 0.0F) {
  if (contrast <= 0.0) return;
  Random random(seed, "caustics");
  CountRays(WavesOf(random, kSize), kSize, tile_);
  for (int pass = 0; pass < 2; ++pass)
    Soften(kSize, tile_);
  Standardize(tile_);
}

float Caustics::Sample(float across, float along) const {
  // Conversion to int is far cheaper than std::floor; the offset keeps it from rounding upwards.
  constexpr int kOffset = 1 << 14;
  const int left = static_cast<int>(across + kOffset) - kOffset;
  const int top = static_cast<int>(along + kOffset) - kOffset;
  constexpr unsigned kMask = kSize - 1;
  const unsigned column = static_cast<unsigned>(left) & kMask;
  const unsigned next = (column + 1) & kMask;
  const float* upper = &tile_[(static_cast<unsigned>(top) & kMask) * kSize];
  const float* lower = &tile_[(static_cast<unsigned>(top + 1) & kMask) * kSize];
  const float right = across - static_cast<float>(left);
  const float low = along - static_cast<float>(top);
  const float above = upper[column] + right * (upper[next] - upper[column]);
  const float below = lower[column] + right * (lower[next] - lower[column]);
  return above + low * (below - above);
}

Caustics::Layer Caustics::At(const Eigen::Vector3d& p_W, Seconds time) const {
  return {*this, p_W, time};
}

namespace {

// The second layer is turned and larger, so that their seams never meet.
constexpr double kTurned = 0.47;
constexpr double kKept = 0.55;

}  // namespace

Caustics::Layer::Layer(const Caustics& caustics, const Eigen::Vector3d& p_W, Seconds time)
    : caustics_(&caustics), north_(p_W.x()), east_(p_W.y()) {
  // Lines of many waves overlap and blur on the way down: half of the contrast is left at 6 m.
  constexpr double kHalf = 6.0;
  amplitude_ = static_cast<float>(caustics.contrast_ *
                                  std::exp2(-(std::max(p_W.z(), 1.0) - 1.0) / (kHalf - 1.0)));
  // A wave of 30 cm travels at 0.7 m/s. Wrapped to the tile before floats get coarse.
  const auto wrapped = [](double meters) {
    return static_cast<float>(std::fmod(meters * (kSize / kTile), kSize));
  };
  const double t = time.value();
  first_along_ = wrapped(north_ + 0.55 * t);
  first_across_ = wrapped(east_ + 0.20 * t);
  second_along_ = wrapped(kTurned * east_ + kKept * north_ - 0.35 * t);
  second_across_ = wrapped(kKept * east_ - kTurned * north_ + 0.45 * t);
}

float Caustics::Layer::LightAt(const Eigen::Vector2d& p_W) const {
  constexpr auto kTexels = static_cast<float>(kSize / kTile);
  constexpr auto kA = static_cast<float>(kKept);
  constexpr auto kB = static_cast<float>(kTurned);
  const float across = static_cast<float>(p_W.y() - east_) * kTexels;
  const float along = static_cast<float>(p_W.x() - north_) * kTexels;
  const float one = caustics_->Sample(across + first_across_, along + first_along_);
  const float other = caustics_->Sample(kA * across - kB * along + second_across_,
                                        kB * across + kA * along + second_along_);
  return std::max(1.0F + amplitude_ * 0.70710678F * (one + other), 0.15F);
}

}  // namespace limpet
