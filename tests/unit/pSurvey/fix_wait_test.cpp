// SPDX-License-Identifier: MIT
#include "apps/pSurvey/fix_wait.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

using namespace literals;

constexpr FixWait kWait{.target = 0.3_m, .shortest = 20.0_s, .longest = 100.0_s};

NavState WithSigmas(double north, double east) {
  NavState nav;
  nav.sd_north = north, nav.sd_east = east;
  nav.gps.is_valid = true;
  return nav;
}

TEST(FixWait, EndsWhenBothAxesAreKnownWellEnough) {
  EXPECT_FALSE(kWait.IsOver(50.0_s, WithSigmas(0.25, 0.31)));
  EXPECT_FALSE(kWait.IsOver(50.0_s, WithSigmas(0.31, 0.25)));
  EXPECT_TRUE(kWait.IsOver(50.0_s, WithSigmas(0.3, 0.25)));
}

TEST(FixWait, IsNoShorterThanAReflectionMayLast) {
  EXPECT_FALSE(kWait.IsOver(19.0_s, WithSigmas(0.1, 0.1)));
  EXPECT_TRUE(kWait.IsOver(20.0_s, WithSigmas(0.1, 0.1)));
}

TEST(FixWait, IsNoLongerThanItsCeilingHoweverPoorTheFixes) {
  EXPECT_FALSE(kWait.IsOver(99.0_s, WithSigmas(0.8, 0.8)));
  EXPECT_TRUE(kWait.IsOver(100.0_s, WithSigmas(0.8, 0.8)));
}

TEST(FixWait, TakesNoPlaceForFixedThatDeadReckoningAloneIsSureOf) {
  NavState silent = WithSigmas(0.1, 0.1);
  silent.gps.is_valid = false;
  EXPECT_FALSE(kWait.IsOver(50.0_s, silent));
}

TEST(FixWait, WaitsItsTimeForANavigationThatStatesNoSigma) {
  EXPECT_FALSE(kWait.IsOver(99.0_s, WithSigmas(0.0, 0.0)));
  EXPECT_TRUE(kWait.IsOver(100.0_s, WithSigmas(0.0, 0.0)));
}

TEST(FixWait, IsShorterWhereAFormerSessionsObjectsWillTellThePlace) {
  SurveyParams params;
  params.fix_target = 0.3_m, params.former_fix_target = 0.5_m;
  EXPECT_EQ(FixWait::BeforeDive(params, false).target, 0.3_m);
  EXPECT_EQ(FixWait::BeforeDive(params, true).target, 0.5_m);
  params.fix_target = 0.8_m;
  EXPECT_EQ(FixWait::BeforeDive(params, true).target, 0.8_m);
}

}  // namespace
}  // namespace limpet
