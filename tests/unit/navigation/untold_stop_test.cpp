// SPDX-License-Identifier: MIT
#include "estimation/navigation/untold_stop.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kRate = 1.0 / 600.0;  // [1/s]

TEST(UntoldStop, StraightAheadItsVarianceGrowsAsTheThirdPowerOfTime) {
  UntoldStop stop;
  for (int i = 0; i < 400; ++i)
    stop.GoOn({0.05, 0.0}, 0.1);
  const double expected = kRate * 0.25 * std::pow(40.0, 3.0) / 3.0;
  EXPECT_NEAR(stop.Covariance(kRate)(0, 0), expected, 0.01 * expected);
  EXPECT_NEAR(stop.Covariance(kRate)(1, 1), 0.0, 1e-9);
}

TEST(UntoldStop, WhoComesBackIsNoFurtherOffThanThat) {
  UntoldStop stop;
  for (int i = 0; i < 200; ++i)
    stop.GoOn({0.05, 0.0}, 0.1);
  for (int i = 0; i < 200; ++i)
    stop.GoOn({-0.05, 0.0}, 0.1);
  const double straight = kRate * 0.25 * std::pow(40.0, 3.0) / 3.0;
  EXPECT_LT(stop.Covariance(kRate)(0, 0), 0.3 * straight);
}

TEST(UntoldStop, WhoStandsCannotStop) {
  UntoldStop stop;
  stop.GoOn({0.0, 0.0}, 60.0);
  EXPECT_EQ(stop.Covariance(kRate).trace(), 0.0);
}

}  // namespace
}  // namespace limpet
