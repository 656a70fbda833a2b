// SPDX-License-Identifier: MIT
#include "limpet/survey/grid_frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SurveyArea, IsRefusedWithItsValuesWhenNoGridCanHoldIt) {
  const SurveyArea good{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10};
  EXPECT_FALSE(ProblemOf(good).has_value());
  for (const double edge : {-10.0, -30.0, 2e6, 1e300, std::nan(""), HUGE_VAL}) {
    SurveyArea area = good;
    area.east_max = edge;
    EXPECT_TRUE(ProblemOf(area).has_value()) << edge;
  }
  for (const double bad : {-1.0, 1e9, std::nan(""), HUGE_VAL}) {
    SurveyArea wide = good, thick = good;
    wide.margin = thick.object_height_max = bad;
    EXPECT_TRUE(ProblemOf(wide).has_value()) << bad;
    EXPECT_TRUE(ProblemOf(thick).has_value()) << bad;
  }
}

TEST(SurveyArea, MayBeHalfAKilometreWideAndItsGridCanBeMade) {
  const SurveyArea large{.north_min = -250, .north_max = 250, .east_min = -250, .east_max = 250};
  ASSERT_FALSE(ProblemOf(large).has_value());
  EXPECT_EQ(FrameOf(large, kGridCell_m).rows, 2000);
}

TEST(SurveyArea, MayBeASquareKilometreAndNotMuchMore) {
  SurveyArea area{.north_min = 0.0, .north_max = 1000.0, .east_min = 0.0, .east_max = 1000.0};
  EXPECT_FALSE(ProblemOf(area).has_value());
  area.north_max += 2000.0;
  EXPECT_TRUE(ProblemOf(area).has_value());
}

TEST(GridFrame, StandsForEachCellByAPlaceInsideItThatIsAlwaysTheSame) {
  const GridFrame frame{
      .north_min = -3.0, .east_min = 7.0, .cell_m = 0.5, .rows = 40, .columns = 30};
  double off_north = 0.0;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const PlanePoint place = SamplePoint(frame, row, column);
      const double north = (place.x() - frame.north_min) / frame.cell_m - row;
      const double east = (place.y() - frame.east_min) / frame.cell_m - column;
      ASSERT_TRUE(north >= 0.0 && north < 1.0 && east >= 0.0 && east < 1.0) << row << " " << column;
      EXPECT_EQ(SamplePoint(frame, row, column), place);
      off_north += north;
    }
  }
  EXPECT_NEAR(off_north / (frame.rows * frame.columns), 0.5, 0.03) << "all over the cell";
}

}  // namespace
}  // namespace limpet
