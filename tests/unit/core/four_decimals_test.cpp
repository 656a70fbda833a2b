// SPDX-License-Identifier: MIT
#include "limpet/core/four_decimals.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ToFourDecimals, IsTheNearestAndHalvesGoAwayFromZero) {
  EXPECT_EQ(ToFourDecimals(1.23456), 1.2346);
  EXPECT_EQ(ToFourDecimals(-1.23444), -1.2344);
  EXPECT_EQ(ToFourDecimals(0.03125), 0.0313);
  EXPECT_EQ(ToFourDecimals(-0.03125), -0.0313);
  EXPECT_EQ(ToFourDecimals(7.0), 7.0);
}

TEST(ToFourDecimals, LeavesWhatIsRoundedAlready) {
  for (int i = -2000; i < 2000; ++i) {
    const double rounded = ToFourDecimals(0.0137 * i);
    EXPECT_EQ(ToFourDecimals(rounded), rounded);
  }
}

TEST(ToFourDecimals, LeavesWhatIsNoFiniteNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ToFourDecimals(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(ToFourDecimals(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace limpet
