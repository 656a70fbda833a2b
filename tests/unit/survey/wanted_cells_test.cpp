// SPDX-License-Identifier: MIT
#include "limpet/survey/wanted_cells.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {
namespace {

/// A harbour with an arm and a pier in it, 60 x 50 m.
SurveyArea Harbour() {
  SurveyArea area = AreaWithin({{0.0, 0.0}, {60.0, 3.0}, {52.0, 50.0}, {31.0, 48.0}, {24.0, 20.0}});
  area.keep_out = "{10,20:14,30:9,44}{2,1:3,1:3,2:2,2}";
  area.object_height_max = 2.0;
  return area;
}

TEST(WantedCells, AreThoseWhoseSamplePointIsInTheAreaAndInNoZone) {
  const SurveyArea area = Harbour();
  const SurveyShape shape = *SurveyShape::Of(area);
  const SurveyGrid grid(area);
  std::size_t wanted = 0;
  for (int row = 0; row < grid.frame().rows; ++row) {
    for (int column = 0; column < grid.frame().columns; ++column) {
      const bool is_wanted = shape.Wants(grid.SamplePoint(row, column));
      ASSERT_EQ(grid.IsWanted(row, column), is_wanted) << row << ", " << column;
      wanted += is_wanted ? 1 : 0;
    }
  }
  EXPECT_EQ(grid.wanted_cells(), wanted);
  EXPECT_GT(wanted, 0U);
}

TEST(WantedCells, DroppedOnesAreCountedNoMoreAndLeaveTheRest) {
  const GridFrame frame{.rows = 40, .columns = 70};
  WantedCells cells(frame);
  EXPECT_EQ(cells.count(), 2800U);
  cells.Drop(39, 69);
  cells.Drop(39, 69);
  cells.Drop(0, 31);
  EXPECT_EQ(cells.count(), 2798U);
  EXPECT_FALSE(cells.Has(39, 69));
  EXPECT_FALSE(cells.Has(0, 31));
  EXPECT_TRUE(cells.Has(39, 68));
  EXPECT_TRUE(cells.Has(0, 32));
}

}  // namespace
}  // namespace limpet
