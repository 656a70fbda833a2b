// SPDX-License-Identifier: MIT
#include "limpet/sensors/simulated_battery.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const ThrusterVector kRest = ThrusterVector::Zero();
constexpr Seconds kMinute(60.0);

/// A sheet that is right.
BatterySheet Exact() {
  BatterySheet sheet;
  sheet.capacity_sigma = 0.0;
  sheet.gauge_sigma = 0.0;
  return sheet;
}

SimulatedBattery BatteryOf(const BatterySheet& sheet, const BatteryErrorParams& errors = {},
                           std::uint64_t seed = 1) {
  return {sheet, errors, Random(seed)};
}

FaultSchedule FaultOf(const ScenarioFault& fault) {
  FaultSchedule faults({fault});
  faults.Update(Seconds(0.0));
  return faults;
}

TEST(SimulatedBattery, FeedsTheHotelAtRestAndThrustersOnTop) {
  SimulatedBattery resting = BatteryOf(Exact()), working = BatteryOf(Exact());
  const FaultSchedule faults;
  resting.Draw(kRest, kMinute, faults);
  ThrusterVector six = ThrusterVector::Zero();
  six.head<6>().setConstant(0.25);
  working.Draw(six, kMinute, faults);
  EXPECT_NEAR(resting.Truth().used_wh, 55.0 / 60.0, 1e-9);
  EXPECT_NEAR(working.Truth().used_wh, (55.0 + 6.0 * 90.0 / 8.0) / 60.0, 1e-9);
}

TEST(SimulatedBattery, IsOffFromItsSheetByTheSeed) {
  const BatterySheet sheet;
  const double one = BatteryOf(sheet, {}, 1).Truth().capacity_wh;
  EXPECT_EQ(BatteryOf(sheet, {}, 1).Truth().capacity_wh, one);
  EXPECT_NE(BatteryOf(sheet, {}, 2).Truth().capacity_wh, one);
  EXPECT_NEAR(one, sheet.capacity_wh, 3.0 * sheet.capacity_sigma * sheet.capacity_wh);
}

TEST(SimulatedBattery, ItsGaugeSaysMoreThanThereIsWhereTheScenarioSaysSo) {
  BatteryErrorParams errors;
  errors.charge = 0.5;
  errors.gauge_off = 0.2;
  SimulatedBattery battery = BatteryOf(Exact(), errors);
  EXPECT_NEAR(battery.Gauge({}).charge, 0.7, 1e-9);
  EXPECT_NEAR(battery.Truth().charge, 0.5, 1e-9);
}

TEST(SimulatedBattery, ItsGaugeSticksOnDemandAndOnlyMeanwhile) {
  SimulatedBattery battery = BatteryOf(Exact());
  const FaultSchedule stuck =
      FaultOf({.what = "gauge_stuck", .when = {}, .at = {}, .lasts = {}, .app = {}});
  const double first = battery.Gauge(stuck).charge;
  battery.Draw(kRest, Seconds(3600.0), stuck);
  EXPECT_EQ(battery.Gauge(stuck).charge, first);
  EXPECT_LT(battery.Gauge({}).charge, first - 0.1);
}

TEST(SimulatedBattery, DrawsMoreAndLosesCellsOnDemand) {
  SimulatedBattery loaded = BatteryOf(Exact()), broken = BatteryOf(Exact()),
                   sound = BatteryOf(Exact());
  loaded.Draw(
      kRest, kMinute,
      FaultOf(
          {.what = "battery_load", .when = {}, .at = {}, .lasts = {}, .size = 300.0, .app = {}}));
  broken.Draw(
      kRest, kMinute,
      FaultOf({.what = "cells_lost", .when = {}, .at = {}, .lasts = {}, .size = 0.15, .app = {}}));
  sound.Draw(kRest, kMinute, {});
  EXPECT_NEAR(loaded.Truth().used_wh, 355.0 / 60.0, 1e-9);
  EXPECT_NEAR(*broken.Gauge({}).volts / *sound.Gauge({}).volts, 0.85, 0.01);
  EXPECT_NEAR(broken.Gauge({}).charge, sound.Gauge({}).charge, 0.001);
}

TEST(SimulatedBattery, GoesOnWithWhatItHadInAFormerLife) {
  const SimulatedBattery battery(Exact(), {}, Random(1), 0.3);
  EXPECT_EQ(battery.Truth().charge, 0.3);
}

TEST(SimulatedBattery, SaysNoVoltageOnceItIsOff) {
  BatteryErrorParams errors;
  errors.charge = 0.0;
  SimulatedBattery battery = BatteryOf(Exact(), errors);
  battery.Draw(kRest, kMinute, {});
  EXPECT_TRUE(battery.is_off());
  EXPECT_EQ(battery.Gauge({}).volts, 0.0);
}

}  // namespace
}  // namespace limpet
