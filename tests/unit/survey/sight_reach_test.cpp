// SPDX-License-Identifier: MIT
#include "limpet/survey/sight_reach.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SightReach, InClearWaterTheWholeImageCounts) { EXPECT_EQ(ShareInSight({4.0, 2.5}, 8.0), 1.0); }

TEST(SightReach, MurkCutsTheCornersOff) {
  const double share = ShareInSight({4.0, 2.5}, 4.5);
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 0.75);
}

TEST(SightReach, WhatIsHardlyInSightIsNotSought) {
  EXPECT_EQ(ShareInSight({4.0, 2.5}, 4.2), 0.0);
  EXPECT_EQ(ShareInSight({4.0, 2.5}, 3.0), 0.0);
  EXPECT_EQ(ShareInSight({4.0, 2.5}, 0.0), 0.0);
}

}  // namespace
}  // namespace limpet
