// SPDX-License-Identifier: MIT
#include "limpet/scoring/coverage_score.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

SurveyArea ScoredArea() {
  return {.north_min = -8.0,
          .north_max = 8.0,
          .east_min = -10.0,
          .east_max = 10.0,
          .margin = 2.0,
          .object_height_max = 2.0};
}

ReportSettings FromFourMetres() {
  ReportSettings settings;
  settings.altitude_m = 4.0;
  settings.object_radius_m = 0.5;
  settings.object_height_max_m = 2.0;
  return settings;
}

Scenario WithBox(double height_m) {
  Scenario scenario;
  scenario.seabed = {.depth_m = 7.5, .roughness_m = 0.0};
  scenario.obstacles = {{.name = "wreck",
                         .shape = "box",
                         .north_m = 0.0,
                         .east_m = 0.0,
                         .size_m = {4.0, 8.0},
                         .height_m = height_m}};
  return scenario;
}

/// Lanes from south to north, 2.5 m apart, but for those within three metres of the datum.
SurveyFrames LanesBesideTheMiddle() {
  SurveyFrames frames;
  for (double east = -10.0; east <= 10.0; east += 2.5) {
    if (std::abs(east) < 6.0) continue;
    for (double north = -10.0; north <= 10.0; north += 0.25) {
      frames.X_WB.push_back({{north, east, 3.5}, 0.0, 0.0, 0.0});
      frames.path_m.push_back(0.25 * static_cast<double>(frames.path_m.size()));
      frames.time_s.push_back(0.5 * static_cast<double>(frames.time_s.size()));
    }
  }
  return frames;
}

CoverageScore CoverageOf(const Scenario& scenario) {
  return ScoreCoverage(LanesBesideTheMiddle(), ScoredArea(), scenario, FromFourMetres(), {});
}

double ByReason(const CoverageScore& score, WhyUnseen why) {
  return score.unseen.band_by_reason[static_cast<std::size_t>(why)];
}

TEST(CoverageScore, GroundUnderAnObstacleIsNotToBeSeenAndNamedAsSuch) {
  const CoverageScore with = CoverageOf(WithBox(5.0)), without = CoverageOf(WithBox(0.0));
  EXPECT_GT(with.detected_band, without.detected_band + 0.02);
  EXPECT_NEAR(ByReason(with, WhyUnseen::kObstacle), 32.0 / 320.0, 0.01);
  EXPECT_EQ(ByReason(without, WhyUnseen::kObstacle), 0.0);
}

TEST(CoverageScore, ReasonsAddUpToWhatWasNotSeenOfTheArea) {
  const CoverageScore score = CoverageOf(WithBox(5.0));
  double sum = 0.0;
  for (const double share : score.unseen.band_by_reason)
    sum += share;
  EXPECT_NEAR(sum, score.unseen.band, 1e-9);
  EXPECT_GT(score.unseen.band, 1.0 - score.detected_band) << "the obstacle's ground is of the area";
}

TEST(CoverageScore, AnObstacleThatTheVehiclePassesOverLeavesItsGroundToBeSeen) {
  EXPECT_EQ(ByReason(CoverageOf(WithBox(2.5)), WhyUnseen::kObstacle), 0.0);
}

TEST(CoverageScore, WhatTheDiveShowedFromWhereTheVehicleMapsWasSeen) {
  Scenario scenario;
  scenario.seabed = {.depth_m = 7.5, .roughness_m = 0.0};
  SurveyFrames frames = LanesBesideTheMiddle();
  const auto score = [&] {
    return ScoreCoverage(frames, ScoredArea(), scenario, FromFourMetres(), {});
  };
  const CoverageScore without = score();
  for (int i = 0; i < 3; ++i)
    frames.dive_X_WB.push_back({{0.0, 0.0, 0.5}, 0.0, 0.0, 0.0});
  EXPECT_EQ(score().covered, without.covered) << "from 7 m it does not map";
  for (int i = 0; i < 3; ++i)
    frames.dive_X_WB.push_back({{0.0, 0.0, 2.0}, 0.0, 0.0, 0.0});
  const CoverageScore with = score();
  EXPECT_GT(with.covered, without.covered + 0.05);
  EXPECT_GT(with.detected_band, without.detected_band + 0.03);
  EXPECT_LT(with.unseen.band, without.unseen.band - 0.03);
  EXPECT_GT(with.curve.seabed.front(), without.curve.seabed.front() + 0.05)
      << "a survey begins with what its dive has shown";
  EXPECT_EQ(with.curve.seabed.back(), with.covered);
  EXPECT_EQ(with.curve.band.back(), with.detected_band);
}

/// One lane due north, 2 m west of a wall that runs north.
CoverageScore ScoreBesideAWall(double height_m) {
  Scenario scenario = WithBox(height_m);
  scenario.obstacles[0].size_m = {30.0, 0.2};
  SurveyFrames frames;
  for (double north = -10.0; north <= 10.0; north += 0.25) {
    frames.X_WB.push_back({{north, -2.0, 3.5}, 0.0, 0.0, 0.0});
    frames.path_m.push_back(0.25 * static_cast<double>(frames.path_m.size()));
    frames.time_s.push_back(0.5 * static_cast<double>(frames.time_s.size()));
  }
  return ScoreCoverage(frames, ScoredArea(), scenario, FromFourMetres(), {{1.0, 0.8, 7.4}});
}

TEST(CoverageScore, WhatAnObstacleHidesIsNotSeen) {
  const CoverageScore with = ScoreBesideAWall(6.0), without = ScoreBesideAWall(0.0);
  EXPECT_LT(with.covered, 0.9 * without.covered);
  EXPECT_TRUE(without.prior_opis_seen_path_m.has_value());
  EXPECT_FALSE(with.prior_opis_seen_path_m.has_value());
  EXPECT_GT(ByReason(with, WhyUnseen::kObstacle), 0.02);
}

}  // namespace
}  // namespace limpet
