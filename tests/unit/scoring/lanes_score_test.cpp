// SPDX-License-Identifier: MIT
#include "limpet/scoring/lanes_score.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "limpet/scoring/scorer.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

constexpr double kSpeed = 0.5;

SurveyArea Table1Area() {
  SurveyArea area;
  area.north_min = -15.0, area.north_max = 15.0;
  area.east_min = -18.0, area.east_max = 18.0;
  return area;
}

SurveyBesideLanes InTheCorner() {
  return {.start = {.north = -12.5, .east = -15.5, .yaw = 0.5 * std::numbers::pi},
          .home = {.north = -12.5, .east = -15.5},
          .speed = kSpeed,
          .dive_X_WB = {}};
}

std::optional<LanesScore> LanesOver(const SurveyArea& area) {
  return ScoreLanes(area, InTheCorner(), Table1Scenario(), Table1Settings());
}

double WayTo(const std::vector<CoverageLevel>& levels, double share) {
  for (const CoverageLevel& level : levels) {
    if (level.level == share) return level.path_m.value_or(-1.0);
  }
  return -1.0;
}

TEST(LanesScore, TakesWhatLanesOverTable1AreKnownToTake) {
  const auto lanes = LanesOver(Table1Area());
  ASSERT_TRUE(lanes);
  EXPECT_NEAR(WayTo(lanes->band, 0.95), 365.0, 15.0);
  EXPECT_NEAR(WayTo(lanes->band, 0.99), 385.0, 25.0);
  EXPECT_NEAR(lanes->path_m, 415.0, 15.0);
  EXPECT_NEAR(lanes->time_s, lanes->path_m / kSpeed, 1e-9);
  EXPECT_GE(lanes->passes, 9);
}

TEST(LanesScore, IsNoLessThanAreaOverSwath) {
  const auto lanes = LanesOver(Table1Area());
  ASSERT_TRUE(lanes);
  const double least = *LowerBoundOf(Table1Area(), Table1Settings()).path_m();
  EXPECT_GT(lanes->path_m, least);
  EXPECT_GT(WayTo(lanes->band, 0.95), 0.95 * least);
}

TEST(LanesScore, ReachesItsSharesOnTheWayThatItSays) {
  for (const double north_max : {2.0, 6.0, 15.0}) {
    SurveyArea area = Table1Area();
    area.north_max = north_max;
    const auto lanes = LanesOver(area);
    ASSERT_TRUE(lanes);
    for (const auto* levels : {&lanes->seabed, &lanes->band}) {
      for (const CoverageLevel& level : *levels) {
        EXPECT_LE(level.path_m.value_or(0.0), lanes->path_m + 1e-6) << level.level;
      }
    }
    EXPECT_GT(WayTo(lanes->band, 0.95), 0.0);
  }
}

TEST(LanesScore, NeedNotShowAgainWhatTheDiveHasShown) {
  SurveyBesideLanes beside = InTheCorner();
  for (double north = -14.0; north <= 14.0; north += 0.5) {  // a dive as long as the area
    for (int look = 0; look < 3; ++look)
      beside.dive_X_WB.push_back({{north, -15.0, 3.5}, 0.0, 0.0, 0.0});
  }
  const auto lanes = ScoreLanes(Table1Area(), beside, Table1Scenario(), Table1Settings());
  const auto alone = LanesOver(Table1Area());
  ASSERT_TRUE(lanes && alone);
  double most_gained = 0.0;  // which lanes are best, and so which share gains most, hangs by a hair
  for (const auto levels : {&LanesScore::seabed, &LanesScore::band}) {
    for (const CoverageLevel& level : (*lanes).*levels) {
      const double gained = WayTo((*alone).*levels, level.level) - level.path_m.value();
      EXPECT_GT(gained, 0.0) << level.level;
      most_gained = std::max(most_gained, gained);
    }
  }
  EXPECT_GT(most_gained, 10.0);
}

TEST(LanesScore, GoesAroundAKeepOutZone) {
  SurveyArea area = Table1Area();
  area.keep_out = "{-4,-4:4,-4:4,4:-4,4}";
  const auto lanes = LanesOver(area);
  ASSERT_TRUE(lanes);
  EXPECT_GT(WayTo(lanes->band, 0.95), 0.0) << "what is left of the area is seen";
}

TEST(LanesScore, LeadsInFromAStartOutsideByTheTransit) {
  SurveyArea area = Table1Area();
  area.operating_region = "{-20,-17:20,-17:20,17:-20,17}";
  area.transit = "{30,0:19,0}";
  const Pose2 slip{.north = 20.0, .east = 40.0, .yaw = std::numbers::pi};
  const auto lanes = ScoreLanes(area,
                                {.start = slip,
                                 .home = {.north = slip.north, .east = slip.east},
                                 .speed = kSpeed,
                                 .dive_X_WB = {}},
                                Table1Scenario(), Table1Settings());
  ASSERT_TRUE(lanes);
  EXPECT_GT(lanes->path_m, LanesOver(Table1Area())->path_m + 30.0) << "in and out again";
  EXPECT_GT(WayTo(lanes->band, 0.95), 0.0);
}

TEST(LanesScore, IsNoneForAnAreaThatIsNoneOrTooLarge) {
  SurveyArea upside_down = Table1Area();
  upside_down.north_max = -20.0;
  EXPECT_FALSE(LanesOver(upside_down));
  SurveyArea vast = Table1Area();
  vast.north_max = 400.0, vast.east_max = 400.0;
  EXPECT_FALSE(LanesOver(vast));
}

TEST(LanesScore, BeginsWhereTheSurveyDidAndAsFastAsThatWas) {
  const SyntheticSession survey;
  const SessionScore score = ScoreSession(RecordOf(survey), Table1Scenario(), Table1Settings());
  ASSERT_TRUE(score.lanes && score.survey_path_m);
  EXPECT_NEAR(score.lanes->path_m / score.lanes->time_s, 0.5, 0.01);
  EXPECT_NEAR(score.lanes->path_m, LanesOver(Table1Area())->path_m, 40.0)
      << "it begins elsewhere over the same area";
}

TEST(LanesScore, IsNoneWithoutASurvey) {
  SyntheticSession brief;
  brief.seconds_of_survey = 0.0;
  const SessionScore score = ScoreSession(RecordOf(brief), Table1Scenario(), Table1Settings());
  EXPECT_FALSE(score.lanes);
}

}  // namespace
}  // namespace limpet
