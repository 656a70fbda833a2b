// SPDX-License-Identifier: MIT
#include "limpet/waypoints/leg_plan.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// North from the origin.
LegPlan NorthLeg(double length) {
  LegPlan plan;
  plan.SetEnd(0, {.x = 0.0, .y = 0.0});
  plan.SetEnd(1, {.x = 0.0, .y = length});
  return plan;
}

TEST(LegPlan, IsLaidAboutItsMiddle) {
  LegPlan plan;
  EXPECT_FALSE(plan.is_set());
  plan.Lay({.x = 10.0, .y = 20.0}, {.bearing = 90.0 * kDegree, .distance = 40.0});
  ASSERT_TRUE(plan.is_set());
  EXPECT_NEAR(plan.end(0).x, -10.0, 1e-9);
  EXPECT_NEAR(plan.end(1).x, 30.0, 1e-9);
  EXPECT_NEAR(plan.center().y, 20.0, 1e-9);
  EXPECT_NEAR(plan.bearing(), 90.0 * kDegree, 1e-9);
  EXPECT_NEAR(plan.length(), 40.0, 1e-9);
  plan.Lay({}, {.bearing = 0.0, .distance = -5.0});
  EXPECT_NEAR(plan.length(), 1.0, 1e-9) << "never without a length";
}

/// Of every bias, radius, side and extension: it begins and ends at the leg's end, on the leg's
/// heading and the opposite one, and nowhere turns more tightly than its radius.
TEST(LegPlan, TurnsAboutSmoothlyWhereverTheLoopLies) {
  for (const double bias : {-1.0, -0.5, 0.0, 0.3, 1.0}) {
    for (const double radius : {5.0, 20.0}) {
      for (const bool is_port : {true, false}) {
        LegPlan plan = NorthLeg(100.0);
        plan.SetPointGap(1.0 * kDegree);
        plan.turn(1) = {.radius = radius, .extension = 0.0, .bias = bias, .is_port = is_port};
        const std::vector<MapPoint> points = plan.TurnPoints(1);
        ASSERT_GT(points.size(), 200U);
        EXPECT_NEAR(DistanceBetween(points.front(), plan.end(1)), 0.0, 1e-9);
        EXPECT_NEAR(DistanceBetween(points.back(), plan.end(1)), 0.0, 1e-6);
        double heading = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i) {
          const double now = BearingTo(points[i - 1], points[i]);
          const double turned = std::abs(WrapAngle(now - heading));
          EXPECT_LT(turned, 1.5 * kDegree) << bias << " " << radius << " " << i;
          heading = now;
        }
        EXPECT_NEAR(std::abs(WrapAngle(heading)), std::numbers::pi, 1.5 * kDegree);
      }
    }
  }
}

TEST(LegPlan, LoopsToTheSideThatItIsToldTo) {
  LegPlan plan = NorthLeg(100.0);
  plan.SetPointGap(1.0 * kDegree);
  plan.turn(1) = {.radius = 10.0, .extension = 0.0, .bias = 0.0, .is_port = true};
  const std::vector<MapPoint> port = plan.TurnPoints(1);
  EXPECT_GT(port[20].x, 0.0) << "a swing to starboard first";
  double north = 0.0, west = 0.0;
  for (const MapPoint& point : port) {
    north = std::max(north, point.y);
    west = std::min(west, point.x);
  }
  EXPECT_NEAR(north, 100.0 + 10.0 * (1.0 + std::sqrt(3.0)), 0.01);
  EXPECT_NEAR(west, -10.0, 0.01);
  plan.turn(1).is_port = false;
  const std::vector<MapPoint> starboard = plan.TurnPoints(1);
  ASSERT_EQ(starboard.size(), port.size());
  for (std::size_t i = 0; i < port.size(); ++i) {
    EXPECT_NEAR(starboard[i].x, -port[i].x, 1e-9);
    EXPECT_NEAR(starboard[i].y, port[i].y, 1e-9);
  }
}

TEST(LegPlan, BeginsATurnFurtherOutAndAtTheOtherEndTheOtherWay) {
  LegPlan plan = NorthLeg(100.0);
  plan.turn(0) = {.radius = 10.0, .extension = 7.0, .bias = 0.0, .is_port = true};
  const std::vector<MapPoint> points = plan.TurnPoints(0);
  EXPECT_NEAR(points.front().y, -7.0, 1e-9);
  EXPECT_EQ(points.back().y, 0.0) << "back at the leg's end";
  EXPECT_LT(points[2].x, 0.0) << "starboard of a vehicle that comes south";
}

TEST(LegPlan, TurnsNoTighterThanItIsAllowedTo) {
  LegPlan plan = NorthLeg(100.0);
  plan.turn(1).radius = 0.5;
  plan.SetLeastRadius(4.0);
  plan.SetPointGap(1.0 * kDegree);
  double north = 0.0;
  for (const MapPoint& point : plan.TurnPoints(1))
    north = std::max(north, point.y);
  EXPECT_NEAR(north, 100.0 + 4.0 * (1.0 + std::sqrt(3.0)), 0.01);
}

}  // namespace
}  // namespace limpet
