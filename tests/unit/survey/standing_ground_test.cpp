// SPDX-License-Identifier: MIT
#include "limpet/survey/standing_ground.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// 30 x 36 m around the datum.
constexpr GridFrame kFrame{
    .north_min = -15.0, .east_min = -18.0, .cell_m = 0.25, .rows = 120, .columns = 144};

Obstacle Piece(double north_min, double north_max, double east_min, double east_max) {
  return {.id = 1,
          .outline = {{north_min, east_min},
                      {north_min, east_max},
                      {north_max, east_max},
                      {north_max, east_min}},
          .top = 1.0};
}

/// The walls of a box as a sonar sees them: a quarter metre thick, in pieces of 1.5 m and less
/// with gaps of half a metre between them.
std::vector<Obstacle> WallsOf(double half_north, double half_east) {
  constexpr double kThick = 0.25, kPiece = 1.5, kGap = 0.5;
  std::vector<Obstacle> walls;
  for (double at = -half_east; at < half_east; at += kPiece + kGap) {
    const double end = std::min(at + kPiece, half_east);
    walls.push_back(Piece(-half_north, -half_north + kThick, at, end));
    walls.push_back(Piece(half_north - kThick, half_north, at, end));
  }
  for (double at = -half_north; at < half_north; at += kPiece + kGap) {
    const double end = std::min(at + kPiece, half_north);
    walls.push_back(Piece(at, end, -half_east, -half_east + kThick));
    walls.push_back(Piece(at, end, half_east - kThick, half_east));
  }
  return walls;
}

double SquareMetres(const std::vector<std::uint32_t>& cells) {
  return static_cast<double>(cells.size()) * kFrame.cell_m * kFrame.cell_m;
}

TEST(StandingGround, IsNoneWhereNothingStands) { EXPECT_TRUE(StandingGround({}, kFrame).empty()); }

TEST(StandingGround, OfAPileIsWhatItsOutlineHolds) {
  const auto cells = StandingGround({Piece(2.0, 3.0, 4.0, 5.0)}, kFrame);
  EXPECT_DOUBLE_EQ(SquareMetres(cells), 1.0);
  EXPECT_EQ(cells.front(), 68U * 144U + 88U);
}

TEST(StandingGround, OfAWreckWhoseWallsWereSeenIsAlsoWhatTheyShutIn) {
  EXPECT_NEAR(SquareMetres(StandingGround(WallsOf(2.0, 3.0), kFrame)), 24.0, 1.0);
}

TEST(StandingGround, OfAWallThatIsSeenFromOneSideIsTheWall) {
  const std::vector<Obstacle> front{Piece(2.0, 2.25, -3.0, -1.0), Piece(2.0, 2.25, -0.5, 1.5),
                                    Piece(2.0, 2.25, 2.0, 3.0)};
  EXPECT_LT(SquareMetres(StandingGround(front, kFrame)), 2.0);
}

TEST(StandingGround, LeavesABasinToBeSurveyedThatTheVehicleIsIn) {
  const std::vector<Obstacle> quays = WallsOf(5.0, 6.0);
  EXPECT_NEAR(SquareMetres(StandingGround(quays, kFrame)), 120.0, 2.0);
  EXPECT_LT(SquareMetres(StandingGround(quays, kFrame, PlanePoint(1.0, 1.0))), 14.0);
  EXPECT_NEAR(SquareMetres(StandingGround(quays, kFrame, PlanePoint(9.0, 1.0))), 120.0, 2.0);
}

TEST(StandingGround, LeavesGroundTooLargeForAnObstacle) {
  EXPECT_LT(SquareMetres(StandingGround(WallsOf(10.0, 8.0), kFrame)), 25.0);
}

/// Quays of a harbour of 700 x 700 m, whose pieces hang together all along.
TEST(StandingGround, OfALongCoastIsEachOfItsOutlines) {
  const GridFrame harbour{
      .north_min = -10.0, .east_min = -10.0, .cell_m = 0.25, .rows = 2900, .columns = 2900};
  std::vector<Obstacle> quays;
  for (double at = 0.0; at < 700.0; at += 10.0) {
    quays.push_back(Piece(at, at + 10.0, 0.0, 1.0));
    quays.push_back(Piece(0.0, 1.0, at, at + 10.0));
  }
  EXPECT_NEAR(SquareMetres(StandingGround(quays, harbour)), 1399.0, 0.5);
}

TEST(StandingGround, BeyondTheAreaCountsOnlyWhatIsInIt) {
  const auto cells = StandingGround({Piece(14.0, 17.0, 17.0, 21.0)}, kFrame);
  EXPECT_DOUBLE_EQ(SquareMetres(cells), 1.0);
}

TEST(StandingGround, NeedsNoOutlineOfWhatHasNone) {
  const Obstacle shapeless{.id = 1, .outline = {{1.0, 1.0}, {1.0, 2.0}}, .top = 1.0};
  const Obstacle far_away = Piece(5e5, 5e5 + 1.0, 0.0, 1.0);
  EXPECT_TRUE(StandingGround({shapeless, far_away}, kFrame).empty());
}

}  // namespace
}  // namespace limpet
