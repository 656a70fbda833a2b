// SPDX-License-Identifier: MIT
// Sites of missions are in tests/unit/cli: to read one takes the apps.
#include "limpet/site/site.hpp"

#include <string>

#include <gtest/gtest.h>

namespace limpet {
namespace {

Site MadeUp() {
  return {.name = "made_up",
          .area = {.north_max = 10.0, .east_max = 10.0, .margin = 2.0},
          .start_W = {},
          .wanted_m2 = 100.0,
          .path_m = 50.0};
}

TEST(Site, CountsTheTimeOnlyIfASpeedIsSaid) {
  Site site = MadeUp();
  EXPECT_EQ(site.Summary(), "100 m2 to be seen; lanes and turns of about 50 m");
  site.speed_mps = 0.5;
  EXPECT_EQ(site.Summary(), "100 m2 to be seen; lanes and turns of about 50 m, 100 s at 0.5 m/s");
}

TEST(Site, ThereIsNoneWhereNoMissionIsOrNoAppThatSurveys) {
  EXPECT_FALSE(SiteOf("no_such_mission"));
  EXPECT_FALSE(SiteOf(std::string(LIMPET_SOURCE_DIR) + "/missions/table1/mission.bhv"));
  EXPECT_FALSE(SiteOf(std::string(LIMPET_SOURCE_DIR) + "/missions/table1"))
      << "this program has no pSurvey";
}

TEST(SiteBox, HoldsTheRegionWayPointsAndTheStart) {
  Site site = MadeUp();
  const SiteBox plain = BoxAround(site);
  EXPECT_EQ(plain.low_W, PlanePoint(-2.0, -2.0)) << "the margin is the vehicle's, too";
  EXPECT_EQ(plain.high_W, PlanePoint(12.0, 12.0));
  site.start_W.emplace(-500.0, 7.0);
  site.area.transit = "700,5";  // x is east
  const SiteBox box = BoxAround(site);
  EXPECT_EQ(box.low_W, PlanePoint(-500.0, -2.0));
  EXPECT_EQ(box.high_W, PlanePoint(12.0, 700.0));
}

TEST(SiteBox, IsNotAsWideAsAZoneFarAway) {
  Site site = MadeUp();
  site.area.keep_out = "{-9000,300:9000,300:9000,301:-9000,301}";
  EXPECT_EQ(BoxAround(site).high_W, PlanePoint(12.0, 12.0));
  EXPECT_TRUE(site.Summary().ends_with("; 1 keep-out zone beyond the drawing")) << site.Summary();
}

TEST(ZonesBeyond, AreThoseOfWhichNothingIsDrawn) {
  Site site = MadeUp();
  EXPECT_EQ(ZonesBeyond(site), 0);
  site.area.keep_out = "{2,2:4,2:4,4}{12.5,0:20,0:20,9}{0,30:9,30:9,39}{-90,-9:-80,-9:-80,0}";
  EXPECT_EQ(ZonesBeyond(site), 2) << "the second reaches into the room at the edge";
}

TEST(SiteBox, HoldsARegionThatIsSaid) {
  Site site = MadeUp();
  site.area.operating_region = "{-30,-1:11,-1:11,11:-30,11}";
  EXPECT_EQ(BoxAround(site).low_W, PlanePoint(-1.0, -30.0));
  EXPECT_EQ(BoxAround(site).high_W, PlanePoint(11.0, 11.0)) << "a margin is not added";
}

}  // namespace
}  // namespace limpet
