// SPDX-License-Identifier: MIT
#include "estimation/mapping/anchored_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/mapping/map_params.hpp"
#include "tests/support/grid_heights.hpp"

namespace limpet {
namespace {

const SurveyArea kSurveyedArea{.north_min = -10.0,
                               .north_max = 10.0,
                               .east_min = -10.0,
                               .east_max = 10.0,
                               .margin = 2.0,
                               .object_height_max = 2.0};
constexpr Meters kGridCell(0.25);
constexpr double kFlown = 40.0;  ///< [s]

/// pMap's part of a session: beams and ground, fed alike.
struct GroundSession {
  BeamMap beams{Meters(0.2)};
  AnchoredGrid ground{kSurveyedArea, kGridCell, CameraModel{}, beams, MapParams{}.seam_loss};

  void SettleAll() {
    beams.SettleAll();
    while (!ground.Settle()) {
    }
  }
};

Pose PoseAt(double t, const TrackShift& shift) {
  const Pose X_WB{{-10.0 + 0.5 * t, 2.0 * std::sin(0.1 * t), 3.5}, 0.02 * std::sin(t), 0.01, 0.1};
  return shift.Apply(t, X_WB);
}

/// One second of a way: a ping, and two frames above ground that rises to the north.
void FlySecond(GroundSession& session, double t, const TrackShift& shift = {}) {
  const Pose X_WD = PoseAt(t, shift);
  const double slant = 4.3 - 0.01 * t;
  const PosedBeams ping{.north = X_WD.p_WB.x(),
                        .east = X_WD.p_WB.y(),
                        .down = X_WD.p_WB.z(),
                        .roll = X_WD.roll,
                        .pitch = X_WD.pitch,
                        .yaw = X_WD.yaw,
                        .b1 = slant,
                        .b2 = slant,
                        .b3 = slant,
                        .b4 = slant,
                        .sd_down = {}};
  session.beams.Add(t, ping, BeamEnds(X_WD, {slant, slant, slant, slant}));
  session.ground.TakePings();
  session.ground.Observe({.t = t + 0.1, .X_WB = PoseAt(t + 0.1, shift), .altitude = 3.9});
  session.ground.Observe({.t = t + 0.6, .X_WB = PoseAt(t + 0.6, shift), .altitude = 3.9});
}

void Fly(GroundSession& session, const TrackShift& shift = {}) {
  for (double t = 0.0; t < kFlown; t += 1.0) {
    FlySecond(session, t, shift);
  }
}

void Tell(GroundSession& session, const TrackShift& shift) {
  session.beams.Shift(shift);
  session.ground.Shift(shift);
}

void ExpectSameGround(const SurveyGrid& a, const SurveyGrid& b) {
  EXPECT_EQ(HeightsOf(a), HeightsOf(b));
  for (int row = 0; row < a.frame().rows; ++row) {
    for (int column = 0; column < a.frame().columns; ++column) {
      ASSERT_EQ(a.Seabed(row, column), b.Seabed(row, column));
      ASSERT_EQ(a.SeenFloor(row, column), b.SeenFloor(row, column));
    }
  }
}

/// Drift that a closed loop took off: more of it the later; in steps that add exactly.
const TrackShift kLoopClosed{.steps = {{0.0, 0.0, 0.0, 0.0, 0.0}, {64.0, 1.0, -2.0, 0.0, 0.0}}};

TEST(AnchoredGrid, WithoutShiftsIsThePlainGrid) {
  GroundSession session;
  Fly(session);
  EXPECT_TRUE(session.ground.Settle());
  SurveyGrid plain(kSurveyedArea, kGridCell.value());
  BeamMap beams{Meters(0.2)};
  for (std::size_t ping = 0; ping < session.beams.pings(); ++ping) {
    for (const Eigen::Vector3d& end_W : session.beams.SeabedEnds(ping)) {
      plain.SetSeabed(end_W);
    }
    const auto t = static_cast<double>(ping);
    plain.Observe(PoseAt(t + 0.1, {}), 3.9, CameraModel{});
    plain.Observe(PoseAt(t + 0.6, {}), 3.9, CameraModel{});
  }
  ExpectSameGround(session.ground.grid(), plain);
}

TEST(AnchoredGrid, AfterAShiftIsCellForCellTheGridOfTheCorrectedTrack) {
  GroundSession session, corrected;
  Fly(session);
  Fly(corrected, kLoopClosed);
  const double before = session.ground.grid().coverage().seabed;
  Tell(session, kLoopClosed);
  EXPECT_EQ(session.ground.grid().coverage().seabed, before) << "not at once";
  session.SettleAll();
  ExpectSameGround(session.ground.grid(), corrected.ground.grid());
}

TEST(AnchoredGrid, GoesOnWithNewGroundWhileItIsMadeAnew) {
  const TrackShift shift{{{0.0, 0.0, 0.0, 0.0, 0.0}, {32.0, 2.0, 0.0, 0.0, 0.0}}};
  GroundSession session, corrected;
  for (double t = 0.0; t < 32.0; t += 1.0) {
    FlySecond(session, t);
    FlySecond(corrected, t, shift);
  }
  Tell(session, shift);
  double t = 33.0;
  for (; !session.beams.Settle(300) || !session.ground.Settle(2000); t += 1.0) {
    FlySecond(session, t);
    FlySecond(corrected, t);
  }
  EXPECT_GT(t, 43.0);
  ExpectSameGround(session.ground.grid(), corrected.ground.grid());
}

TEST(AnchoredGrid, IsDoneAtLastHoweverOftenTheTrackMoves) {
  GroundSession session;
  Fly(session);
  const auto sees_the_east = [&] { return session.ground.grid().SeenHeight(40, 72).has_value(); };
  ASSERT_FALSE(sees_the_east()) << "8 m off the way";
  int ticks = 0;
  while (!sees_the_east() && ++ticks < 1000) {
    Tell(session, {{{kFlown, 0.0, 0.125, 0.0, 0.0}}});
    static_cast<void>(session.beams.Settle());
    static_cast<void>(session.ground.Settle(3000));
  }
  EXPECT_LT(ticks, 200);
}

TEST(AnchoredGrid, StaysForLessThanHalfACellAndAddsUp) {
  GroundSession session;
  Fly(session);
  static_cast<void>(session.ground.grid().TakeDelta());
  const TrackShift small{{{kFlown, 0.0, 0.09375, 0.0, 0.0}}};
  Tell(session, small);
  session.SettleAll();
  EXPECT_TRUE(session.ground.grid().TakeDelta().cells.empty());
  Tell(session, small);
  session.SettleAll();
  GroundSession corrected;
  Fly(corrected, {{{kFlown, 0.0, 0.1875, 0.0, 0.0}}});
  ExpectSameGround(session.ground.grid(), corrected.ground.grid());
}

TEST(AnchoredGrid, KeepsToTheWaterWhenItIsMadeAnew) {
  GroundSession session, corrected;
  session.ground.SetReach(4.2);
  Fly(session);
  Tell(session, kLoopClosed);
  static_cast<void>(session.beams.Settle(1'000'000));
  static_cast<void>(session.ground.Settle(100));
  session.ground.SetReach(4.0);
  session.SettleAll();
  corrected.ground.SetReach(4.0);
  Fly(corrected, kLoopClosed);
  ExpectSameGround(session.ground.grid(), corrected.ground.grid());
}

/// Two lanes whose images just meet at the band's top, the second at a place that is known so well.
void FlyTwoLanes(AnchoredGrid& ground, const PlaceSigma& second) {
  const double half = 2.0 * CameraModel{}.half_across() - SurveyGrid::kDiscInset;
  for (const double side : {-1.0, 1.0}) {
    for (double t = 0.0; t < 60.0; t += 0.25) {
      ground.Observe({.t = t + (side > 0.0 ? 100.0 : 0.0),
                      .X_WB = {{-12.0 + 0.4 * t, side * half, 3.5}, 0.0, 0.0, 0.0},
                      .altitude = 4.0,
                      .sigma = side > 0.0 ? second : PlaceSigma{}});
    }
  }
}

TEST(AnchoredGrid, DoesNotTakeASeamForDoneThatMayHaveComeApart) {
  BeamMap beams{Meters(0.2)};
  AnchoredGrid sure{kSurveyedArea, kGridCell, CameraModel{}, beams, MapParams{}.seam_loss};
  AnchoredGrid unsure{kSurveyedArea, kGridCell, CameraModel{}, beams, MapParams{}.seam_loss};
  FlyTwoLanes(sure, {});
  FlyTwoLanes(unsure, {.absolute = 0.5, .beside = 0.5});
  sure.Judge();
  unsure.Judge();
  EXPECT_LT(unsure.coverage().done_band_top, sure.coverage().done_band_top);
  EXPECT_LT(unsure.coverage().band_top, sure.coverage().band_top);
  EXPECT_GT(unsure.recent_allowance(), 0.05);
}

TEST(AnchoredGrid, EarnsGroundAnewOnceAClosedLoopMakesThePlacesSure) {
  BeamMap beams{Meters(0.2)};
  AnchoredGrid sure{kSurveyedArea, kGridCell, CameraModel{}, beams, MapParams{}.seam_loss};
  AnchoredGrid ground{kSurveyedArea, kGridCell, CameraModel{}, beams, MapParams{}.seam_loss};
  FlyTwoLanes(sure, {});
  FlyTwoLanes(ground, {.absolute = 0.0, .beside = 0.5});
  ground.Shift({.steps = {{0.0, 0.0, 0.0, 0.0, 0.0}, {200.0, 0.0, 0.0, 0.0, 0.0}},
                .sigmas = {{0.0, 0.0, 0.0}, {200.0, 0.0, 0.0}}});
  while (!ground.Settle()) {
  }
  ExpectSameGround(ground.grid(), sure.grid());
  ground.Judge();
  sure.Judge();
  EXPECT_GT(sure.coverage().band_top, 0.3);
  EXPECT_EQ(ground.coverage().band_top, sure.coverage().band_top);
}

TEST(AnchoredGrid, ClaimAndWhatIsDoneLeaveOutGroundThatAnObstacleStandsOnThroughShifts) {
  const std::vector<Obstacle> wreck{
      {.id = 1, .outline = {{-9.0, 4.0}, {-9.0, 9.0}, {9.0, 9.0}, {9.0, 4.0}}, .top = 1.0}};
  GroundSession session;
  Fly(session);
  session.ground.Judge();
  const Coverage before = session.ground.coverage();
  session.ground.SetObstacles(wreck);
  session.ground.Judge();
  const Coverage after = session.ground.coverage();
  EXPECT_GT(*after.done_seabed, 1.1 * *before.done_seabed);
  EXPECT_GT(after.seabed, 1.1 * before.seabed);
  Tell(session, kLoopClosed);
  session.SettleAll();
  session.ground.Judge();
  EXPECT_EQ(session.ground.grid().wanted_cells(), 80U * 80U - 72U * 20U);
  EXPECT_GT(session.ground.coverage().seabed, before.seabed);
}

TEST(AnchoredGrid, WhatAnObstacleHidWasNotSeenOnceNoMoreOfItIsFound) {
  const std::vector<Obstacle> pile{
      {.id = 1, .outline = {{0.0, 3.5}, {0.0, 4.0}, {0.5, 4.0}, {0.5, 3.5}}, .top = 1.0}};
  GroundSession session, knew_before;
  Fly(session);
  const double before = session.ground.grid().coverage().seabed;
  session.ground.SetObstacles(pile);
  for (double t = kFlown; t < kFlown + 22.0; t += 1.0)
    FlySecond(session, t);
  session.SettleAll();
  knew_before.ground.SetObstacles(pile);
  for (double t = 0.0; t < kFlown + 22.0; t += 1.0)
    FlySecond(knew_before, t);
  knew_before.SettleAll();
  ExpectSameGround(session.ground.grid(), knew_before.ground.grid());
  EXPECT_LT(session.ground.grid().coverage().seabed, before);
}

}  // namespace
}  // namespace limpet
