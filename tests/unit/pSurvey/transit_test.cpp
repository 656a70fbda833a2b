// SPDX-License-Identifier: MIT
#include "apps/pSurvey/transit.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

NavState At(double north, double east) {
  NavState nav;
  nav.north = north, nav.east = east;
  return nav;
}

SurveyArea Area() {
  return {
      .north_min = -15.0, .north_max = 15.0, .east_min = -18.0, .east_max = 18.0, .margin = 2.0};
}

TEST(SurveyTransit, ComesNearerStraightWhereTheMissionGivesNoWay) {
  const Region region(Area());
  Transit transit;
  EXPECT_TRUE(transit.Track(At(0.0, 60.0), region));
  EXPECT_NEAR(transit.to_go_m(), 40.0, 1e-9);
  EXPECT_FALSE(transit.Track(At(0.0, 59.5), region)) << "that may be sway";
  EXPECT_FALSE(transit.Track(At(0.0, 70.0), region));
  EXPECT_TRUE(transit.Track(At(0.0, 50.0), region));
  EXPECT_TRUE(transit.Track(At(0.0, 10.0), region));
  EXPECT_TRUE(transit.is_over());
}

TEST(SurveyTransit, ComesNearerByTheMissionsWayAlsoWhereThatLeadsOffFirst) {
  SurveyArea area = Area();
  area.transit = "{60,300:0,300}";  // x east, y north
  const Region region(area);
  Transit transit;
  for (double north = 0.0; north < 300.0; north += 10.0)
    EXPECT_TRUE(transit.Track(At(north, 60.0), region)) << north;
  for (double east = 58.0; east > 2.0; east -= 10.0)
    EXPECT_TRUE(transit.Track(At(300.0, east), region)) << east;
  for (double north = 296.0; north > 20.0; north -= 10.0)
    EXPECT_TRUE(transit.Track(At(north, 0.0), region)) << north;
  EXPECT_TRUE(transit.Track(At(10.0, 0.0), region));
  EXPECT_TRUE(transit.is_over());
}

TEST(SurveyTransit, IsOverAtOnceInTheArea) {
  Transit transit;
  EXPECT_TRUE(transit.Track(At(0.0, 0.0), Region(Area())));
  EXPECT_TRUE(transit.is_over());
  EXPECT_FALSE(transit.is_under_way());
}

}  // namespace
}  // namespace limpet
