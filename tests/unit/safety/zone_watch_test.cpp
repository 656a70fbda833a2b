// SPDX-License-Identifier: MIT
#include "limpet/safety/zone_watch.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SurveyArea AreaWithZones() {
  SurveyArea area{.north_min = 0.0, .north_max = 100.0, .east_min = 0.0, .east_max = 100.0};
  area.keep_out = "{10,10:13,10:13,30:10,30}{50,50:90,50:90,90:50,90}";  // x east, y north
  return area;
}

TEST(ZoneWatch, IsFullInTheMiddleOfAZoneHoweverNarrow) {
  const ZoneWatch watch(AreaWithZones());
  EXPECT_DOUBLE_EQ(watch.ShareAt({5.0, 5.0}).value(), 0.0);
  EXPECT_NEAR(watch.ShareAt({20.0, 11.5}).value(), 1.0, 0.03);
  EXPECT_NEAR(watch.ShareAt({20.0, 10.75}).value(), 0.5, 0.02);
  EXPECT_NEAR(watch.ShareAt({70.0, 60.0}).value(), 0.5, 0.02);
}

TEST(ZoneWatch, CountsTheNarrowArmOfAWideZoneByTheArmsOwnWidth) {
  SurveyArea area{.north_min = 0.0, .north_max = 100.0, .east_min = 0.0, .east_max = 100.0};
  // 40 m by 40 m, and from its eastern side an arm of 3 m by 30 m.
  area.keep_out = "{20,20:60,20:60,38:90,38:90,41:60,41:60,60:20,60}";
  const ZoneWatch watch(area);
  EXPECT_NEAR(watch.ShareAt({39.5, 80.0}).value(), 1.0, 0.1);
  EXPECT_NEAR(watch.ShareAt({38.75, 80.0}).value(), 0.5, 0.06);
  EXPECT_NEAR(watch.ShareAt({40.0, 30.0}).value(), 0.5, 0.03);
  EXPECT_NEAR(watch.ShareAt({40.0, 21.5}).value(), 0.075, 0.03);
}

TEST(ZoneWatch, MakesLittleOfASharpCornerThatIsClipped) {
  SurveyArea area{.north_min = 0.0, .north_max = 100.0, .east_min = 0.0, .east_max = 100.0};
  area.keep_out = "{10,10:40,14:10,18}";
  EXPECT_LT(ZoneWatch(area).ShareAt({14.0, 39.0}).value(), 0.2);
}

TEST(ZoneWatch, KnowsNothingWhereThereIsNoZone) {
  EXPECT_FALSE(ZoneWatch().ShareAt({0.0, 0.0}));
  EXPECT_FALSE(ZoneWatch(SurveyArea{.north_max = 10.0, .east_max = 10.0}).ShareAt({5.0, 5.0}));
}

}  // namespace
}  // namespace limpet
