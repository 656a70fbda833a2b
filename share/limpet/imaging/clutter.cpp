// SPDX-License-Identifier: MIT
#include "limpet/imaging/clutter.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "limpet/core/split_mix.hpp"

namespace limpet {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// A short stream of draws of its own for each cell (SplitMix64).
class CellDraws {
 public:
  CellDraws(std::uint64_t seed, int north, int east)
      : state_(
            seed ^ (static_cast<std::uint64_t>(static_cast<std::int64_t>(north)) * 0x8da6b343U) ^
            (static_cast<std::uint64_t>(static_cast<std::int64_t>(east)) * 0xd8163841ULL << 20U)) {
    static_cast<void>(Uniform());
  }
  double Uniform() {
    state_ += kGoldenStep;
    return static_cast<double>(SplitMixed(state_) >> 11U) * 0x1p-53;
  }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  template <class Choices>
  auto Of(const Choices& choices) {
    return choices[static_cast<std::size_t>(Uniform() * static_cast<double>(choices.size()))];
  }
  /// Poisson, by Knuth's product; means here are below 10.
  int Count(double mean) {
    const double limit = std::exp(-mean);
    int count = 0;
    for (double product = Uniform(); product > limit; product *= Uniform())
      ++count;
    return count;
  }

 private:
  std::uint64_t state_;
};

Growth DrawGrowth(CellDraws& draws) {
  Growth growth;
  const double kind = draws.Uniform();
  const double size = draws.Uniform();
  growth.turn = static_cast<float>(draws.Uniform(0.0, kFullTurn));
  growth.form = static_cast<float>(draws.Uniform());
  const auto bright = static_cast<float>(draws.Uniform(0.6, 1.4));
  if (kind < 0.45) {
    growth.kind = GrowthKind::kStone;
    growth.radius = 0.04 + 0.30 * size * size * size;
    growth.color = bright * Eigen::Array3f(0.10F, 0.12F, 0.13F);
  } else if (kind < 0.70) {
    growth.kind = GrowthKind::kPlant;
    growth.radius = 0.10 + 0.25 * size;
    // Green, brown and red algae.
    const std::array<Eigen::Array3f, 3> kTints{Eigen::Array3f(0.03F, 0.13F, 0.04F),
                                               Eigen::Array3f(0.02F, 0.07F, 0.09F),
                                               Eigen::Array3f(0.05F, 0.03F, 0.14F)};
    growth.color = bright * draws.Of(kTints);
  } else if (kind < 0.82) {
    growth.kind = GrowthKind::kStarfish;
    growth.radius = 0.05 + 0.10 * size;
    const std::array<Eigen::Array3f, 3> kTints{Eigen::Array3f(0.03F, 0.16F, 0.50F),
                                               Eigen::Array3f(0.04F, 0.06F, 0.38F),
                                               Eigen::Array3f(0.08F, 0.20F, 0.26F)};
    growth.color = bright * draws.Of(kTints);
  } else if (kind < 0.92) {
    growth.kind = GrowthKind::kUrchin;
    growth.radius = 0.05 + 0.05 * size;
    growth.color = bright * Eigen::Array3f(0.018F, 0.012F, 0.016F);
  } else {
    growth.kind = GrowthKind::kShell;
    growth.radius = 0.02 + 0.05 * size;
    growth.color = bright * Eigen::Array3f(0.40F, 0.45F, 0.48F);
  }
  return growth;
}

Eigen::Matrix3d LyingAt(double heading, double tilt) {
  return (Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

Solid DrawLitter(CellDraws& draws) {
  static const std::array<std::string, 7> kPaints{"white", "red",    "blue",  "green",
                                                  "black", "yellow", "orange"};
  Solid litter;
  const double kind = draws.Uniform();
  const double heading = draws.Uniform(0.0, kFullTurn);
  const double flat = 0.5 * std::numbers::pi;
  litter.color = draws.Of(kPaints);
  if (kind < 0.30) {  // cans, bottles and pipes
    litter.kind = SolidKind::kCylinder;
    litter.radius = draws.Uniform(0.03, 0.06);
    litter.height = litter.radius * draws.Uniform(3.0, 12.0);
    litter.R_WS = LyingAt(heading, flat + draws.Uniform(-0.1, 0.1));
  } else if (kind < 0.50) {  // planks
    litter.kind = SolidKind::kBox;
    litter.radius = draws.Uniform(0.02, 0.06);
    litter.height = draws.Uniform(0.3, 1.2);
    litter.R_WS = LyingAt(heading, flat);
  } else if (kind < 0.65) {  // bags and lids
    litter.kind = SolidKind::kCylinder;
    litter.radius = draws.Uniform(0.08, 0.2);
    litter.height = 0.03;
    litter.R_WS = LyingAt(heading, draws.Uniform(-0.3, 0.3));
  } else if (kind < 0.80) {  // balls and floats
    litter.radius = draws.Uniform(0.06, 0.18);
  } else if (kind < 0.90) {  // buckets
    litter.kind = SolidKind::kCone;
    litter.radius = draws.Uniform(0.12, 0.18);
    litter.height = 0.3;
    litter.top_share = 0.75;
    litter.R_WS = LyingAt(heading, flat + 0.1);
  } else {
    litter.kind = SolidKind::kTyre;
    litter.radius = draws.Uniform(0.25, 0.4);
    litter.height = 0.2;
    litter.color = "black";
    litter.R_WS = LyingAt(heading, draws.Uniform(-0.2, 0.2));
  }
  return litter;
}

}  // namespace

void Clutter::Collect(const Area& area, SeabedRelief& relief, std::vector<Growth>& growth,
                      std::vector<Solid>& litter) const {
  for (int north = static_cast<int>(std::floor(area.south)); north < area.north; ++north) {
    for (int east = static_cast<int>(std::floor(area.west)); east < area.east; ++east) {
      CellDraws draws(seed_, north, east);
      const int natural = draws.Count(density_.natural_per_m2);
      const int lost = draws.Count(density_.litter_per_m2);
      for (int i = 0; i < natural; ++i) {
        Growth one = DrawGrowth(draws);
        one.north = north + draws.Uniform();
        one.east = east + draws.Uniform();
        growth.push_back(one);
      }
      for (int i = 0; i < lost; ++i) {
        Solid one = DrawLitter(draws);
        const double at_north = north + draws.Uniform();
        const double at_east = east + draws.Uniform();
        // Sunk in by a fifth.
        const double depth = relief.At({at_north, at_east}).depth - 0.6 * one.ReachDown();
        one.p_W = {at_north, at_east, depth};
        litter.push_back(std::move(one));
      }
    }
  }
}

}  // namespace limpet
