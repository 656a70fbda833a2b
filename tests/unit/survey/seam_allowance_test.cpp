// SPDX-License-Identifier: MIT
#include "limpet/survey/seam_allowance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(SeamAllowance, IsNoneWhereTheVehicleKnowsItsPlaceWell) {
  EXPECT_EQ(SeamAllowance(Meters(0.0), Meters(0.05)), 0.0);
  EXPECT_EQ(SeamAllowance(Meters(0.12), Meters(0.05)), 0.0);
}

TEST(SeamAllowance, LeavesASeamNoWiderThanWasAskedOnAverage) {
  Random random(3, "seam");
  for (const double beside : {0.2, 0.4, 0.8}) {
    const double overlap = 2.0 * SeamAllowance(Meters(beside), Meters(0.05));
    double gap = 0.0;
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) {
      gap += std::max(0.0, random.Normal(beside) - overlap) / kDraws;
    }
    EXPECT_NEAR(gap, 0.05, 0.006) << beside;
  }
}

TEST(SeamAllowance, GrowsWithDoubtAndIsBounded) {
  double before = 0.0;
  for (double beside = 0.1; beside < 20.0; beside *= 1.3) {
    const double allowance = SeamAllowance(Meters(beside), Meters(0.05));
    EXPECT_GE(allowance, before);
    EXPECT_LE(allowance, kMostSeamAllowance);
    before = allowance;
  }
}

}  // namespace
}  // namespace limpet
