// SPDX-License-Identifier: MIT
#include "limpet/survey/survey_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/camera_model.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

const std::vector<PlanePoint> kEllShape{{0, 0}, {0, 20}, {10, 20}, {10, 10}, {20, 10}, {20, 0}};

std::string ProblemOfShape(const SurveyArea& area) { return ProblemOf(area).value_or(""); }

TEST(SurveyShape, OfARectangleIsPlain) {
  const SurveyArea table{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0};
  const SurveyShape shape = *SurveyShape::Of(table);
  EXPECT_TRUE(shape.is_plain());
  EXPECT_DOUBLE_EQ(shape.WantedArea(), 30.0 * 36.0);
  EXPECT_EQ(EncodeRecord(table),
            "north_min=-15,north_max=15,east_min=-18,east_max=18,margin=2,object_height_max=2");
}

TEST(SurveyShape, TravelsAsTextAndComesBack) {
  SurveyArea area = AreaWithin(kEllShape);
  area.keep_out = "{2,2:4,2:4,4}{12,2:14,2:14,4}";
  area.transit = PlacesText({{-10, 5}, {-5, 5}});
  const auto again = DecodeRecord<SurveyArea>(EncodeRecord(area));
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, area);
  const SurveyShape shape = *SurveyShape::Of(*again);
  ASSERT_EQ(shape.zones().size(), 2U);
  EXPECT_EQ(shape.zones()[1].low(), PlanePoint(2, 12));  // y is north, x is east
  EXPECT_EQ(shape.transit().back(), PlanePoint(-5, 5));
}

TEST(SurveyShape, WantsTheGroundOfTheAreaOutsideItsZones) {
  SurveyArea area = AreaWithin(kEllShape);
  area.keep_out = "{2,2:6,2:6,6:2,6}";
  const SurveyShape shape = *SurveyShape::Of(area);
  EXPECT_TRUE(shape.Wants({8, 8}));
  EXPECT_FALSE(shape.Wants({4, 4}));
  EXPECT_FALSE(shape.Wants({15, 15}));
  EXPECT_NEAR(shape.WantedArea(), 300.0 - 16.0, 3.0);
}

TEST(SurveyShape, SaysWhichPartIsWrong) {
  SurveyArea area = AreaWithin(kEllShape);
  area.keep_out = "{2,2:6,6:6,2:2,6}";
  EXPECT_THAT(ProblemOfShape(area), HasSubstr("`keep_out` crosses or touches itself"));
  area.keep_out = "{-5,-5:30,-5:30,30:-5,30}";
  EXPECT_THAT(ProblemOfShape(area), HasSubstr("`keep_out` holds all of it"));
  area.keep_out.reset();
  area.operating_region = "here";
  EXPECT_THAT(ProblemOfShape(area), HasSubstr("`operating_region` is no list of points"));
  area.operating_region.reset();
  area.north_max = 40.0;
  EXPECT_THAT(ProblemOfShape(area), HasSubstr("are to be its box"));
}

TEST(SurveyGrid, CountsTheGroundOfItsShapeAlone) {
  SurveyArea area = AreaWithin(kEllShape);
  SurveyGrid grid(area);
  EXPECT_NEAR(static_cast<double>(grid.wanted_cells()), 300.0 / (0.25 * 0.25), 60.0);
  // Everything east of the L's corner is looked at, in the area or not: a half of it is wanted.
  for (double north = 0.0; north <= 20.0; north += 1.0) {
    for (double east = 14.0; east <= 20.0; east += 1.0) {
      Pose X_WB;
      X_WB.p_WB = {north, east, 3.5};
      grid.Observe(X_WB, 4.0, CameraModel{});
    }
  }
  const double seen = grid.coverage().seabed;
  EXPECT_GT(seen, 80.0 / 300.0);
  EXPECT_LT(seen, 110.0 / 300.0);
}

}  // namespace
}  // namespace limpet
