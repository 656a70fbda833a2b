// SPDX-License-Identifier: MIT
#include "limpet/energy/way_power.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr MetersPerSecond kCruise(0.5);

struct OfSheets {
  VehicleParams vehicle;
  BatterySheet sheet;
  WayPower power{vehicle, sheet};
};

TEST(WayPower, IsMoreThanTheHotelAndGrowsWithSpeed) {
  const OfSheets of;
  const double slow = of.power.Cruising(MetersPerSecond(0.3));
  EXPECT_GT(slow, of.power.AtRest());
  EXPECT_GT(of.power.AtRest(), of.sheet.hotel_w);
  EXPECT_GT(of.power.Cruising(MetersPerSecond(0.6)), slow);
  EXPECT_TRUE(std::isinf(of.power.Cruising(MetersPerSecond(5.0))));
}

TEST(WayPower, AgainstACurrentIsThatOfTheSpeedThroughTheWater) {
  const OfSheets of;
  const WaterCurrent southward{.north = -0.2, .east = 0.0};
  EXPECT_NEAR(of.power.In(southward, {.course = 0.0, .speed = kCruise}),
              of.power.Cruising(MetersPerSecond(0.7)), 1e-9);
  EXPECT_NEAR(of.power.In(southward, {.course = kPi, .speed = kCruise}),
              of.power.Cruising(MetersPerSecond(0.3)), 1e-9);
}

TEST(WayPower, TakesAsMuchOnEitherSideOfTheCurrent) {
  const OfSheets of;
  const WaterCurrent current{.north = 0.15, .east = 0.1};
  const double sets_to = std::atan2(current.east, current.north);
  for (const double angle : {0.3, 1.0, 2.5}) {
    EXPECT_NEAR(of.power.In(current, {.course = sets_to + angle, .speed = kCruise}),
                of.power.In(current, {.course = sets_to - angle, .speed = kCruise}), 1e-9);
  }
}

TEST(WayPower, CostsOneMetreInStillWaterAndNoMoreThanTheDearest) {
  const OfSheets of;
  for (const double cost : of.power.CostsOf({}, kCruise).metres) {
    EXPECT_NEAR(cost, 1.0, 1e-12);
  }
  const CourseCost torrent = of.power.CostsOf({.north = 5.0, .east = 0.0}, kCruise);
  for (const double cost : torrent.metres) {
    EXPECT_EQ(cost, WayPower::kDearest);
  }
}

/// Drag grows with the square of the speed, what thrusters draw faster still: what a lane against
/// the current takes more, the lane back does not give back.
TEST(WayPower, OfLanesAcrossTheCurrentIsLessThanOfLanesToAndFroInIt) {
  const OfSheets of;
  const CourseCost cost = of.power.CostsOf({.north = 0.2, .east = 0.0}, kCruise);
  const double along = 0.5 * (cost.At(0.0) + cost.At(kPi));
  const double across = 0.5 * (cost.At(0.5 * kPi) + cost.At(-0.5 * kPi));
  EXPECT_GT(along, 1.05);
  EXPECT_LT(across, along - 0.05);
  EXPECT_GT(across, 1.0);
}

}  // namespace
}  // namespace limpet
