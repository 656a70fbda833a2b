// SPDX-License-Identifier: MIT
#include "limpet/mission/seabed.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

constexpr double kLongestWave_m = 8.0;
constexpr double kShortestWave_m = 1.0;

/// Uniform in [0, 1) from a hash: seeding an engine would cost more than all the waves.
double Unit(std::uint64_t seed, const char* what, std::size_t index) {
  const std::uint64_t bits = MixSeed(MixSeed(seed, what) + index, "seabed");
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// cos(2 pi turns) to 4e-6, written so that the compiler can do several at once.
inline double CosOfTurns(double turns) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to a whole number
  const double whole = (turns + kRound) - kRound;
  const double u = (0.25 - std::abs(turns - whole)) * (2.0 * std::numbers::pi);
  const double s = u * u;  // Taylor series of sin(u), |u| <= pi / 2
  return u * (1.0 + s * (-1.0 / 6.0 + s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s / 362880.0))));
}

}  // namespace

Seabed::Seabed(const Scenario::Seabed& scenario)
    : depth_(scenario.depth_m),
      slope_north_(std::tan(RadiansFromDegrees(scenario.slope_deg)) *
                   std::cos(RadiansFromDegrees(scenario.slope_toward_deg))),
      slope_east_(std::tan(RadiansFromDegrees(scenario.slope_deg)) *
                  std::sin(RadiansFromDegrees(scenario.slope_toward_deg))),
      amplitude_(scenario.roughness_m * std::sqrt(2.0 / static_cast<double>(kWaves))) {
  const auto seed = static_cast<std::uint64_t>(scenario.seed);
  for (std::size_t i = 0; i < kWaves; ++i) {
    // One wavelength from each twelfth of the octaves, so that no seed lacks a scale.
    const double share = (static_cast<double>(i) + Unit(seed, "length", i)) / double{kWaves};
    const double wavelength = kShortestWave_m * std::pow(kLongestWave_m / kShortestWave_m, share);
    const double direction = 2.0 * std::numbers::pi * Unit(seed, "direction", i);
    turns_north_[i] = std::cos(direction) / wavelength;
    turns_east_[i] = std::sin(direction) / wavelength;
    phase_[i] = Unit(seed, "phase", i);
  }
}

double Seabed::Depth(const Eigen::Vector2d& p_W) const {
  std::array<double, kWaves> waves{};
  for (std::size_t i = 0; i < kWaves; ++i) {
    waves[i] = CosOfTurns(turns_north_[i] * p_W.x() + turns_east_[i] * p_W.y() + phase_[i]);
  }
  double relief = 0.0;
  for (const double wave : waves) {
    relief += wave;
  }
  return depth_ + slope_north_ * p_W.x() + slope_east_ * p_W.y() + amplitude_ * relief;
}

double SeabedDepth(const Scenario::Seabed& seabed, const Eigen::Vector2d& p_W) {
  return Seabed(seabed).Depth(p_W);
}

}  // namespace limpet
