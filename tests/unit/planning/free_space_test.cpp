// SPDX-License-Identifier: MIT
#include "limpet/planning/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/room.hpp"
#include "limpet/planning/transit_path.hpp"

namespace limpet {
namespace {

constexpr Meters kShapeRadius{3.0};

/// An L of 40 x 40 m without its north-eastern quarter, with a round pier of 12 corners in its
/// corner, and the pilot's half metre.
SurveyArea EllWithPier() {
  SurveyArea area = AreaWithin({{0, 0}, {0, 40}, {20, 40}, {20, 20}, {40, 20}, {40, 0}});
  std::vector<PlanePoint> pier;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 12;
    pier.emplace_back(10.0 + 2.0 * std::cos(angle), 10.0 + 2.0 * std::sin(angle));
  }
  area.keep_out = PlacesText(pier);
  return area;
}

Region ShapeRegion() { return {EllWithPier(), Meters(0.5)}; }

/// By many places of the path.
bool SeemsInside(const Region& region, const DubinsPath& path) {
  bool is_inside = true;
  path.Sample(0.002, [&](const Pose2& pose, double) {
    is_inside =
        is_inside && region.free_space()->Clearance({pose.north, pose.east}) >= -FreeSpace::kTouch;
  });
  return is_inside;
}

TEST(FreeSpace, HoldsAPathExactlyWhenItHoldsEachOfItsPlaces) {
  const Region region = ShapeRegion();
  Random random(7, "paths");
  int inside = 0, outside = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose2 from{random.Uniform(-2.0, 42.0), random.Uniform(-2.0, 42.0),
                     random.Uniform(-3.0, 3.0)};
    const DubinsPath path(from, {{random.Uniform(-0.4, 0.4), random.Uniform(0.5, 8.0)},
                                 {0.0, random.Uniform(0.5, 8.0)}});
    const bool holds = region.Contains(path);
    EXPECT_EQ(holds, SeemsInside(region, path)) << i;
    (holds ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 60);
  EXPECT_GT(outside, 60);
}

TEST(FreeSpace, KnowsFromItsRasterNoOtherThanByEveryBorder) {
  const Region region = ShapeRegion();
  const FreeSpace& space = *region.free_space();
  Random random(8, "places");
  for (int i = 0; i < 20000; ++i) {
    const PlanePoint at(random.Uniform(-4.0, 44.0), random.Uniform(-4.0, 44.0));
    const double clearance = space.Clearance(at);
    for (const double least : {-FreeSpace::kTouch, 0.5, 2.0, clearance - 1e-9, clearance + 1e-9})
      EXPECT_EQ(space.HasClearance(at, least), clearance >= least) << at << ", " << least;
  }
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(space.Contains(PlanePoint(nowhere, 3.0)));
}

TEST(FreeSpace, SeesAnArcThatCutsTheTipOfAZone) {
  SurveyArea area = AreaWithin({{0, 0}, {0, 40}, {40, 40}, {40, 0}});
  area.keep_out = "{19,20:30,19:30,21}";  // a spike that points west, its tip at north 20, east 19
  const Region region(area);
  // Half a turn whose eastern-most place is at north 20.
  const auto passes = [&region](double radius) {
    const Pose2 from{20.0 - radius, 19.0 - radius + 0.01, std::numbers::pi / 2.0};
    return region.Contains(DubinsPath(from, {{-1.0 / radius, std::numbers::pi * radius}}));
  };
  EXPECT_FALSE(passes(3.0));
  const Pose2 clear{17.0, 15.99, std::numbers::pi / 2.0};
  EXPECT_TRUE(region.Contains(DubinsPath(clear, {{-1.0 / 3.0, std::numbers::pi * 3.0}})));
}

TEST(FreeSpace, TouchingABorderIsInside) {
  SurveyArea area = AreaWithin({{0, 0}, {0, 40}, {40, 40}, {40, 0}});
  area.margin = 0.0;
  const Region region(area);
  EXPECT_TRUE(region.Contains(DubinsPath(Pose2{0.0, 0.0, 0.0}, {{0.0, 40.0}})));
  EXPECT_FALSE(region.Contains(DubinsPath(Pose2{0.0, 0.0, 0.0}, {{0.0, 40.01}})));
}

TEST(Region, OfAShapeKnowsWhereAVehicleCanGoOn) {
  const Region region = ShapeRegion();
  EXPECT_TRUE(region.IsRecoverable({5.0, 30.0, 0.0}, kShapeRadius));
  // Between the pier and the south-western corner there is room for a turn one way only.
  EXPECT_FALSE(region.IsRecoverable({10.0, 7.0, std::numbers::pi / 2.0}, kShapeRadius));
  EXPECT_GT(region.Outside({30.0, 30.0, 0.0}), 8.0);
  EXPECT_NEAR(region.Outside({10.0, 10.0, 0.0}), 2.0 * std::cos(std::numbers::pi / 12.0) + 0.5,
              0.1);
}

TEST(HomePath, LeadsAroundTheCornerAndThePierAndStaysInside) {
  const Region region = ShapeRegion();
  Random random(3, "homes");
  for (int i = 0; i < 20; ++i) {
    const Pose2 from{random.Uniform(30.0, 36.0), random.Uniform(4.0, 16.0),
                     random.Uniform(-3.0, 3.0)};
    const Option home = HomePath(from, {random.Uniform(4.0, 16.0), 36.0}, region, kShapeRadius);
    EXPECT_TRUE(region.Contains(home.path)) << i;
    EXPECT_LT(home.path.length(), 75.0);
  }
}

TEST(HomePath, LeavesTheRegionOnceAndNearHome) {
  const Region region = ShapeRegion();
  // Straight ahead lies the notch of the L, which may be land.
  const Option home = HomePath({34.0, 10.0, 0.0}, {8.0, 60.0}, region, kShapeRadius);
  EXPECT_FALSE(region.EntersZone(home.path));
  home.path.Sample(0.5, [&region](const Pose2& pose, double) {
    EXPECT_TRUE(region.Contains(pose) || pose.east > 35.0) << pose.north << " " << pose.east;
  });
}

TEST(TransitPath, FollowsTheMissionsWayInAndTheWayHomeGoesBackByIt) {
  SurveyArea area = EllWithPier();
  area.transit = PlacesText({{60.0, 70.0}, {-20.0, 70.0}, {-20.0, 30.0}});
  const Region region(area, Meters(0.5));
  const auto passes = [](const DubinsPath& path, const PlanePoint& place) {
    double nearest = 1e9;
    path.Sample(0.25, [&](const Pose2& pose, double) {
      nearest = std::min(nearest, (PlanePoint(pose.north, pose.east) - place).norm());
    });
    return nearest < 0.5;
  };
  const auto in = TransitPath({80.0, 60.0, 0.0}, {80.0, 60.0}, region, kShapeRadius);
  ASSERT_TRUE(in);
  EXPECT_TRUE(LeadsInto(region, *in));
  EXPECT_TRUE(region.IsRecoverable(in->path.end(), kShapeRadius));
  const Option home = HomePath({34.0, 10.0, 0.0}, {80.0, 60.0}, region, kShapeRadius);
  for (const PlanePoint& place : region.transit()) {
    EXPECT_TRUE(passes(in->path, place)) << place;
    EXPECT_TRUE(passes(home.path, place)) << place;
  }
  // Half way there it goes on from where it is.
  const auto rest = TransitPath({20.0, 71.0, 3.0}, {80.0, 60.0}, region, kShapeRadius);
  ASSERT_TRUE(rest);
  EXPECT_FALSE(passes(rest->path, region.transit().front()));
  EXPECT_TRUE(passes(rest->path, region.transit().back()));
}

TEST(TransitPath, GoesAllTheWayRoundAHeadlandThatTheWayComesBackBy) {
  SurveyArea area = EllWithPier();
  area.transit = PlacesText({{20.0, 300.0}, {-30.0, 300.0}});
  const Region region(area, Meters(0.5));
  const PlanePoint begin(20.0, 70.0);  // much nearer to the last leg than to the first way point
  const auto in = TransitPath({begin.x(), begin.y(), 0.0}, begin, region, kShapeRadius);
  ASSERT_TRUE(in);
  EXPECT_GT(in->path.length(), 230.0 + 50.0 + 230.0);
  const auto on_first_leg = TransitPath({21.0, 150.0, 1.57}, begin, region, kShapeRadius);
  EXPECT_GT(on_first_leg->path.length(), 150.0 + 50.0 + 230.0);
  const auto on_last_leg = TransitPath({-30.0, 150.0, -1.57}, begin, region, kShapeRadius);
  EXPECT_LT(on_last_leg->path.length(), 200.0);
}

TEST(RestOfWay, BeginsWithTheFirstPlaceForOneWhoIsNotThereYet) {
  const std::vector<PlanePoint> way{{-3.0, 19.0}, {-3.0, 12.0}};
  EXPECT_EQ(RestOfWay(way, {8.0, 18.0}, Meters(3.0)).size(), 2U);  // the leg is nearer, by a hair
  EXPECT_EQ(RestOfWay(way, {-3.0, 16.0}, Meters(3.0)).size(), 1U);
}

/// Two squares joined by a passage of 4 m, too narrow for turns of 3 m; the western one is larger.
Region TwoRooms() {
  SurveyArea area = AreaWithin({{0, 0},
                                {0, 20},
                                {8, 20},
                                {8, 30},
                                {0, 30},
                                {0, 44},
                                {14, 44},
                                {14, 30},
                                {12, 30},
                                {12, 20},
                                {20, 20},
                                {20, 0}});
  area.margin = 0.0;
  return Region(area);
}

TEST(RoomToTurn, IsTheLargestPieceWhereAFullTurnFits) {
  const Region region = TwoRooms();
  const auto near_small = NearestRoom(*region.free_space(), {7.0, 40.0}, 3.0);
  ASSERT_TRUE(near_small);
  EXPECT_LT(near_small->y(), 18.0);
  EXPECT_FALSE(NearestRoom(*region.free_space(), {7.0, 40.0}, 12.0));
}

TEST(RoomToTurn, OfAStartIsThePieceThatItIsInOrThatIsNearest) {
  const Region region = TwoRooms();
  const FreeSpace& space = *region.free_space();
  const auto holds = [&space](const std::vector<std::uint8_t>& room, const PlanePoint& at) {
    return room[*space.raster().At(at)] != 0;
  };
  const PlanePoint west(10.0, 10.0), east(7.0, 37.0), middle(10.0, 25.0), corner(0.5, 43.5);
  for (const PlanePoint& start : {east, corner}) {
    const auto room = RoomToTurnFrom(space, start, 3.0);
    EXPECT_TRUE(holds(room, east));
    EXPECT_FALSE(holds(room, west)) << "through the passage no turn leads";
  }
  EXPECT_TRUE(holds(RoomToTurnFrom(space, middle, 3.0), west)) << "both are as near: the larger";
  EXPECT_FALSE(holds(RoomToTurnFrom(space, {500.0, 0.0}, 3.0), west)) << "out of the raster";
}

}  // namespace
}  // namespace limpet
