// SPDX-License-Identifier: MIT
#include "limpet/scoring/unseen_places.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/scoring/lower_bound.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

// Image at the band's top: 1.68 m to either side. Turning radius: 3 m.
constexpr double kTop = 2.0;

SurveyArea Rectangle() {
  SurveyArea area;
  area.north_min = -15.0, area.north_max = 15.0;
  area.east_min = -18.0, area.east_max = 18.0;
  area.margin = 2.0;
  return area;
}

std::string WhyOf(const UnseenPlace& place, const SurveyArea& area) {
  UnseenCounter counter(area, Table1Settings());
  counter.Add(place);
  std::string why;
  for (std::size_t i = 0; i < kWaysUnseen; ++i) {
    const auto reason = static_cast<WhyUnseen>(i);
    if (counter.Of(reason) > 0) why += NameOf(reason);
  }
  return why;
}

TEST(UnseenPlaces, TellsGroundThatNoPathWentToFromSuchAsHadTooFewLooks) {
  EXPECT_EQ(WhyOf({.at_W = {0.0, 0.0}, .height_m = kTop}, Rectangle()), "not_reached");
  EXPECT_EQ(WhyOf({.at_W = {0.0, 0.0}, .height_m = kTop, .was_seen = true}, Rectangle()),
            "too_few_looks");
}

TEST(UnseenPlaces, ACornerOfARectangleCouldHaveBeenSeen) {
  EXPECT_EQ(WhyOf({.at_W = {14.9, 17.9}, .height_m = kTop}, Rectangle()), "not_reached");
}

TEST(UnseenPlaces, BlamesTheZoneThatLeavesNoRoomBesideIt) {
  SurveyArea area = Rectangle();
  area.keep_out = "{0,-10:16,-10:16,10:0,10}";
  EXPECT_EQ(WhyOf({.at_W = {0.0, 17.9}, .height_m = kTop}, area), "zone");
  EXPECT_EQ(WhyOf({.at_W = {13.0, 17.0}, .height_m = kTop}, area), "not_reached");
}

TEST(UnseenPlaces, BlamesARegionThatIsTooNarrowToTurnIn) {
  SurveyArea area = Rectangle();
  area.east_min = -1.5, area.east_max = 1.5, area.margin = 1.0;
  EXPECT_EQ(WhyOf({.at_W = {0.0, 0.0}, .height_m = kTop}, area), "turn");
}

TEST(UnseenPlaces, BlamesARegionThatStaysAway) {
  SurveyArea area = Rectangle();
  area.operating_region = "{-18,-15:10,-15:10,15:-18,15}";
  EXPECT_EQ(WhyOf({.at_W = {0.0, 17.9}, .height_m = kTop}, area), "clearance");
}

TEST(LowerBound, IsAreaOverTheSwathOfTheBandsTop) {
  const LowerBound bound = LowerBoundOf(Rectangle(), Table1Settings());
  EXPECT_DOUBLE_EQ(bound.area_m2, 1080.0);
  EXPECT_NEAR(bound.swath_m, 3.356, 1e-3);
  EXPECT_NEAR(bound.path_m().value(), 321.8, 0.1);
}

TEST(LowerBound, CountsNoGroundInsideZones) {
  SurveyArea area = Rectangle();
  area.keep_out = "{0,-10:16,-10:16,10:0,10}";
  EXPECT_NEAR(LowerBoundOf(area, Table1Settings()).area_m2, 760.0, 2.0);
}

TEST(LowerBound, IsNoneWhereTheBandReachesTheCamera) {
  ReportSettings settings = Table1Settings();
  settings.object_height_max_m = settings.altitude_m;
  EXPECT_FALSE(LowerBoundOf(Rectangle(), settings).path_m());
}

}  // namespace
}  // namespace limpet
