// SPDX-License-Identifier: MIT
#include "limpet/map_files/depth_field.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// 12 by 12 m, of which a share of the columns is known to `sigma`.
template <class Down>
DepthGrid PartlyKnown(const Down& down, double share, double sigma_m, Random& random) {
  DepthGrid grid;
  grid.frame = {.north_min = -6.0, .east_min = -6.0, .cell_m = 0.2, .rows = 60, .columns = 60};
  for (int row = 0; row < grid.frame.rows; ++row) {
    for (int column = 0; column < grid.frame.columns; ++column) {
      const double at = down(-6.0 + 0.2 * (row + 0.5), -6.0 + 0.2 * (column + 0.5));
      grid.down_m.push_back(random.Chance(share) ? static_cast<float>(at + random.Normal(sigma_m))
                                                 : std::numeric_limits<float>::quiet_NaN());
      grid.sigma_m.push_back(static_cast<float>(sigma_m));
    }
  }
  return grid;
}

/// Rolling ground of many waves, 1-sigma `rough_m` about a slope.
class Ground {
 public:
  Ground(double rough_m, Random& random) {
    constexpr int kWaves = 40;
    for (int i = 0; i < kWaves; ++i) {
      const double course = random.Uniform(0.0, 2.0 * std::numbers::pi);
      const double number = 2.0 * std::numbers::pi / random.Uniform(0.8, 6.0);
      waves_.emplace_back(number * std::cos(course), number * std::sin(course),
                          random.Uniform(0.0, 2.0 * std::numbers::pi));
    }
    height_m_ = rough_m * std::sqrt(2.0 / kWaves);
  }
  double operator()(double north, double east) const {
    double down = 8.0 + 0.1 * north - 0.05 * east;
    for (const Eigen::Vector3d& wave : waves_)
      down += height_m_ * std::sin(wave.x() * north + wave.y() * east + wave.z());
    return down;
  }

 private:
  std::vector<Eigen::Vector3d> waves_;
  double height_m_ = 0.0;
};

TEST(DepthField, OfAColumnThatBeamsMetIsWhatTheySay) {
  Random random(1);
  const DepthGrid grid = PartlyKnown(Ground(0.05, random), 0.5, 0.02, random);
  const DepthField field(grid);
  int met = 0;
  for (double north = -5.9; north < 6.0; north += 0.2) {
    const auto cell = grid.At({north, 0.1});
    if (!cell) continue;
    ++met;
    EXPECT_EQ(field.At({north, 0.1})->down_m, static_cast<double>(grid.down_m[*cell]));
    EXPECT_EQ(field.At({north, 0.1})->sigma_m, static_cast<double>(grid.sigma_m[*cell]));
  }
  EXPECT_GT(met, 10);
}

TEST(DepthField, BetweenColumnsOfASlopeLiesOnTheSlope) {
  Random random(2);
  const auto slope = [](double north, double east) { return 7.0 + 0.3 * north + 0.1 * east; };
  const DepthGrid grid = PartlyKnown(slope, 0.3, 0.001, random);
  const DepthField field(grid);
  for (double north = -5.0; north < 5.0; north += 0.37) {
    const auto depth = field.At({north, 0.5});
    ASSERT_TRUE(depth);
    EXPECT_NEAR(depth->down_m, slope(north, 0.5), 0.3 * 0.2) << "a column is 0.2 m wide";
    EXPECT_LT(depth->sigma_m, 0.02);
  }
}

TEST(DepthField, IsNoSurerThanItIsRight) {
  double square = 0.0, plain = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed, "depth field");
    const Ground ground(random.Uniform(0.02, 0.15), random);
    const double share = random.Uniform(0.1, 0.4);
    const DepthGrid grid = PartlyKnown(ground, share, random.Uniform(0.01, 0.03), random);
    const DepthField field(grid);
    for (double north = -5.3; north < 5.4; north += 0.2) {
      for (double east = -5.3; east < 5.4; east += 0.2) {
        const auto depth = field.At({north, east});
        if (!depth || grid.At({north, east})) continue;
        square += std::pow((depth->down_m - ground(north, east)) / depth->sigma_m, 2);
        plain += std::pow(depth->down_m - ground(north, east), 2);
        ++count;
      }
    }
  }
  ASSERT_GT(count, 10000);
  EXPECT_GT(square / count, 0.4) << "ground of waves is smoother than either form has it";
  EXPECT_LT(square / count, 1.3);
  EXPECT_LT(std::sqrt(plain / count), 0.06);
}

TEST(DepthField, OfRoughGroundTellsLessThanOfSmoothGround) {
  Random random(4);
  const DepthGrid smooth = PartlyKnown(Ground(0.01, random), 0.2, 0.01, random);
  const DepthGrid rough = PartlyKnown(Ground(0.2, random), 0.2, 0.01, random);
  const auto mean_sigma = [](const DepthGrid& grid) {
    const DepthField field(grid);
    double sum = 0.0;
    for (double north = -5.0; north < 5.0; north += 0.2)
      sum += field.At({north, 0.0}).value_or(DepthField::Depth{}).sigma_m;
    return sum;
  };
  EXPECT_GT(mean_sigma(rough), 3.0 * mean_sigma(smooth));
}

TEST(DepthField, SaysNothingFarFromAllThatBeamsMet) {
  Random random(5);
  DepthGrid grid = PartlyKnown([](double, double) { return 7.0; }, 1.0, 0.01, random);
  for (std::size_t cell = 0; cell < grid.down_m.size(); ++cell) {
    if (cell != 0 && cell != 1) grid.down_m[cell] = std::numeric_limits<float>::quiet_NaN();
  }
  const DepthField field(grid);
  EXPECT_TRUE(field.At({-5.7, -5.9}));
  EXPECT_FALSE(field.At({-5.0, -5.9}));
  EXPECT_FALSE(field.At({100.0, 0.0}));
  EXPECT_FALSE(field.At({std::nan(""), 0.0}));
  EXPECT_FALSE(DepthField(DepthGrid{}).At({0.0, 0.0}));
}

}  // namespace
}  // namespace limpet
