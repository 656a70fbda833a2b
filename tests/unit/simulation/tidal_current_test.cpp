// SPDX-License-Identifier: MIT
#include "limpet/simulation/tidal_current.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Eigen::Vector2d kMean(0.2, 0.0);

TEST(TidalCurrent, IsItsMeanWhereNothingElseIsSaid) {
  TidalCurrent current({}, kMean, Random(1));
  EXPECT_EQ(current.At(Seconds(0.0), 0.0), kMean);
  EXPECT_EQ(current.At(Seconds(5000.0), 40.0), kMean);
}

TEST(TidalCurrent, SwingsToEitherSideOnceInAPeriod) {
  TidalCurrent current({.tide_period = Seconds(600.0), .tide_swing = Radians::FromTextUnit(90.0)},
                       kMean, Random(1));
  double least = 0.0, most = 0.0;
  for (double t = 0.0; t < 600.0; t += 1.0) {
    const Eigen::Vector2d now = current.At(Seconds(t), 0.0);
    EXPECT_NEAR(now.norm(), 0.2, 1e-12);
    least = std::min(least, now.y()), most = std::max(most, now.y());
  }
  EXPECT_NEAR(least, -0.2, 1e-4);
  EXPECT_NEAR(most, 0.2, 1e-4);
}

TEST(TidalCurrent, TurnsBackWhereTheTideIsStrongerThanTheMean) {
  TidalCurrent current({.tide_period = Seconds(600.0), .tide_share = 2.0}, kMean, Random(1));
  double least = 1.0, most = 0.0;
  for (double t = 0.0; t < 600.0; t += 1.0) {
    const double north = current.At(Seconds(t), 0.0).x();
    least = std::min(least, north), most = std::max(most, north);
  }
  EXPECT_NEAR(least, -0.2, 1e-3);
  EXPECT_NEAR(most, 0.6, 1e-3);
}

TEST(TidalCurrent, WeakensAndTurnsWithDepth) {
  TidalCurrent current({.shear_per_m = 0.05, .turn_deg_per_m = 9.0}, kMean, Random(1));
  const Eigen::Vector2d deep = current.At(Seconds(0.0), 10.0);
  EXPECT_NEAR(deep.x(), 0.0, 1e-12);
  EXPECT_NEAR(deep.y(), 0.1, 1e-12);
  EXPECT_EQ(current.At(Seconds(0.0), 30.0).norm(), 0.0);
}

TEST(TidalCurrent, UnrestHasItsShareAndItsSeed) {
  const TidalCurrentParams params{.unrest_share = 0.5, .unrest = Seconds(1.0)};
  TidalCurrent one(params, kMean, Random(3)), two(params, kMean, Random(3));
  double squares = 0.0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const Eigen::Vector2d off = one.At(Seconds(2.0 * i), 0.0) - kMean;
    ASSERT_EQ(off, two.At(Seconds(2.0 * i), 0.0) - kMean);
    squares += off.squaredNorm() / 2.0;
  }
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.1, 0.005);
}

}  // namespace
}  // namespace limpet
