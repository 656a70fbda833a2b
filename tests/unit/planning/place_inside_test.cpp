// SPDX-License-Identifier: MIT
#include "limpet/planning/place_inside.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(PlaceInside, IsTheMiddleOfARectangleWhereverTheVehicleStands) {
  const Region region(SurveyArea{-10.0, 20.0, -4.0, 4.0, 2.0, 2.0});
  ASSERT_TRUE(PlaceInside(region, {25.0, 3.0}));
  EXPECT_NEAR((*PlaceInside(region, {25.0, 3.0}) - PlanePoint(5.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST(PlaceInside, IsNearAndRoomyInAnEllWhoseMiddleLiesOutside) {
  const Region region(AreaWithin({{0, 0}, {0, 60}, {14, 60}, {14, 14}, {60, 14}, {60, 0}}));
  const PlanePoint here(59.0, 7.0);
  const auto place = PlaceInside(region, here);
  ASSERT_TRUE(place);
  EXPECT_GT(region.Clearance(*place), 5.0);
  EXPECT_LT((*place - here).norm(), 12.0);
}

TEST(PlaceInside, ContentsItselfWithLessRoomWhereThereIsLittleAndSaysWhereThereIsNone) {
  const auto strip = [](double width) {
    SurveyArea area = AreaWithin({{0, 0}, {0, 40}, {width, 41}, {width, 1}});
    area.margin = 0.0;
    return Region(area);
  };
  const Region narrow = strip(5.0);
  const auto place = PlaceInside(narrow, {0.2, 20.0});
  ASSERT_TRUE(place);
  EXPECT_GT(narrow.Clearance(*place), 1.5);
  EXPECT_FALSE(PlaceInside(strip(0.8), {0.2, 20.0}));
}

}  // namespace
}  // namespace limpet
