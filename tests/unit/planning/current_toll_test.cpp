// SPDX-License-Identifier: MIT
#include "limpet/planning/current_toll.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/planning/lane_tours.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

constexpr double kPi = std::numbers::pi;
/// Of a current that sets to the south: northward is dear, southward cheap.
const CourseCost kSouthward{.metres = {2.0, 1.1, 0.7, 1.1}};

TEST(CurrentToll, IsWhatALegTakesMoreThanInStillWater) {
  EXPECT_NEAR(CurrentToll(kSouthward, DubinsPath({}, {{0.0, 50.0}})), 50.0, 1e-9);
  EXPECT_NEAR(CurrentToll(kSouthward, DubinsPath({.yaw = kPi}, {{0.0, 50.0}})), -15.0, 1e-9);
  EXPECT_NEAR(CurrentToll(kSouthward, DubinsPath({.yaw = 0.5 * kPi}, {{0.0, 50.0}})), 5.0, 1e-9);
}

TEST(CurrentToll, OfAFullCircleIsThatOfTheMeanCourse) {
  const DubinsPath circle({}, {{1.0 / 3.0, 6.0 * kPi}});
  EXPECT_NEAR(CurrentToll(kSouthward, circle), 6.0 * kPi * (4.9 / 4.0 - 1.0), 0.05);
}

TEST(CurrentToll, IsNoneInStillWater) {
  EXPECT_EQ(CurrentToll(CourseCost{}, DubinsPath({.yaw = 1.0}, {{0.2, 9.0}, {0.0, 30.0}})), 0.0);
}

/// A square, so that nothing but the current tells the directions apart.
struct SquareSurvey {
  [[nodiscard]] double CourseOfBestLanes(const CourseCost& cost) {
    TourGoal goal{.early_weight = 0.0, .most_weight = 0.0, .home_W = {0.0, 0.0}};
    goal.course_cost = cost;
    judge.Reset(DubinsPath({-12.0, -12.0, 0.25 * kPi}), goal);
    return LaneTours(judge, {.with_bottom_first = false}).front().front().in.yaw;
  }
  SurveyArea area{-15.0, 15.0, -15.0, 15.0, 2.0, 2.0};
  SurveyGrid grid{area};
  Ground ground{grid, scene::TableFootprint()};
  Region region{area};
  TourJudge judge{ground, region, scene::kRadius};
};

TEST(CurrentToll, TurnsLanesToWhereTheyCostLess) {
  SquareSurvey survey;
  const double north_south_dear = survey.CourseOfBestLanes({.metres = {1.8, 1.1, 1.2, 1.1}});
  const double east_west_dear = survey.CourseOfBestLanes({.metres = {1.1, 1.8, 1.1, 1.2}});
  EXPECT_GT(std::abs(std::sin(north_south_dear)), 0.9);
  EXPECT_GT(std::abs(std::cos(east_west_dear)), 0.9);
}

TEST(CurrentToll, CountsInWhatATourCostsTheWayHomeIncluded) {
  SquareSurvey survey;
  const SurveyTour lane{{.in = {10.0, 0.0, kPi}, .length = 10.0}};
  TourGoal goal{.early_weight = 0.0, .most_weight = 0.0, .home_W = {10.0, 0.0}};
  const DubinsPath start({10.0, 0.0, kPi});
  survey.judge.Reset(start, goal);
  const TourCost still = survey.judge.Cost(lane);
  goal.course_cost = kSouthward;
  survey.judge.Reset(start, goal);
  const TourCost carried = survey.judge.Cost(lane);
  EXPECT_EQ(carried.length, still.length);
  EXPECT_NEAR(carried.toll, -0.3 * 10.0 + 1.0 * 10.0, 1e-9);
  EXPECT_NEAR(carried.total - still.total, carried.toll, 1e-9);
}

}  // namespace
}  // namespace limpet
