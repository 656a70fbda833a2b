// SPDX-License-Identifier: MIT
#include "limpet/scoring/fence_score.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A second from one place (north, east) to the next; surveying from second 2 until `home`.
SessionRecord Flown(const std::vector<std::pair<double, double>>& places, int home = 100) {
  SessionRecord record("discovery");
  record.area = SurveyArea{
      .north_min = 0.0, .north_max = 20.0, .east_min = 0.0, .east_max = 20.0, .margin = 2.0};
  record.area->keep_out = "{30,0:34,0:34,20:30,20}";  // east 30 to 34
  record.phases = {{Seconds(2.0), "SURVEY"}, {Seconds(home), "RETURN"}};
  double t = 0.0;
  for (const auto& [north, east] : places)
    record.truth.Add(Seconds(t++), {.p_WB = {north, east, 4.0}, .roll = 0, .pitch = 0, .yaw = 0});
  return record;
}

TEST(FenceScore, IsZeroForOneThatKeptToThem) {
  const auto score = ScoreFences(Flown({{10, 10}, {10, 11}, {10, 12}, {10, 21}}));
  ASSERT_TRUE(score);
  EXPECT_EQ(score->outside_region_m, 0.0);
  EXPECT_EQ(score->inside_zone_m, 0.0);
}

TEST(FenceScore, CountsHowFarItLeftTheRegionWhileItSurveyed) {
  EXPECT_NEAR(ScoreFences(Flown({{10, 10}, {10, 10}, {10, 10}, {10, 25}}))->outside_region_m, 3.0,
              1e-6);
  EXPECT_EQ(ScoreFences(Flown({{10, 25}, {10, 25}, {10, 25}, {10, 21}}))->outside_region_m, 0.0)
      << "it was on its way in";
  EXPECT_EQ(ScoreFences(Flown({{10, 10}, {10, 10}, {10, 10}, {10, 25}}, 3))->outside_region_m, 0.0)
      << "it was on its way home";
}

TEST(FenceScore, CountsAZoneAlsoOnTheWayInAndHome) {
  EXPECT_NEAR(ScoreFences(Flown({{10, 40}, {10, 31.5}, {10, 10}}))->inside_zone_m, 1.5, 1e-6);
  EXPECT_NEAR(ScoreFences(Flown({{10, 10}, {10, 10}, {10, 10}, {10, 33}}, 3))->inside_zone_m, 1.0,
              1e-6);
}

TEST(FenceScore, SaysNothingWithoutAnArea) {
  SessionRecord record = Flown({{10, 10}});
  record.area.reset();
  EXPECT_FALSE(ScoreFences(record));
}

}  // namespace
}  // namespace limpet
