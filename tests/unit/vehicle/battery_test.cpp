// SPDX-License-Identifier: MIT
#include "limpet/vehicle/battery.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr Seconds kHour(3600.0);

TEST(BatterySheet, VoltageAndChargeTellEachOther) {
  const BatterySheet sheet;
  EXPECT_DOUBLE_EQ(sheet.OpenCircuitVolts(1.0), sheet.full_v);
  EXPECT_DOUBLE_EQ(sheet.OpenCircuitVolts(0.0), sheet.empty_v);
  for (double charge = 0.0; charge <= 1.0; charge += 0.01) {
    EXPECT_NEAR(sheet.ChargeAt(sheet.OpenCircuitVolts(charge)), charge, 1e-9);
  }
  EXPECT_EQ(sheet.ChargeAt(100.0), 1.0);
  EXPECT_EQ(sheet.ChargeAt(0.0), 0.0);
}

TEST(BatterySheet, AThrusterDrawsTheSameEitherWayAndLittleAtLittleThrust) {
  const BatterySheet sheet;
  EXPECT_DOUBLE_EQ(sheet.ThrusterPower(-1.0), sheet.full_thrust_w);
  EXPECT_DOUBLE_EQ(sheet.ThrusterPower(0.25), sheet.full_thrust_w / 8.0);
}

TEST(Battery, GivesWhatItsSheetSaysLessWhatItsResistanceTakes) {
  Battery battery(BatterySheet{}, 1.0);
  for (int i = 0; i < 100; ++i) {
    battery.Draw(48.0, kHour * 0.01);
  }
  EXPECT_NEAR(battery.used_wh(), 48.0, 1e-9);
  EXPECT_LT(battery.charge(), 0.9);
  EXPECT_GT(battery.charge(), 0.899);
}

TEST(Battery, SagsUnderLoad) {
  const BatterySheet sheet;
  Battery battery(sheet, 0.5);
  battery.Draw(300.0, Seconds(0.02));
  EXPECT_NEAR(battery.volts() * battery.amperes(), 300.0, 1e-9);
  EXPECT_NEAR(battery.volts(),
              sheet.OpenCircuitVolts(0.5) - battery.amperes() * sheet.resistance_ohm, 1e-9);
}

TEST(Battery, SwitchesOffForGoodWhenItIsEmpty) {
  Battery battery(BatterySheet{}, 0.05);
  for (int i = 0; i < 1000; ++i) {
    battery.Draw(100.0, kHour * 0.001);
  }
  EXPECT_TRUE(battery.is_off());
  EXPECT_LT(battery.used_wh(), 0.05 * BatterySheet{}.capacity_wh);
  EXPECT_EQ(battery.volts(), 0.0);
  EXPECT_EQ(battery.amperes(), 0.0);
}

TEST(Battery, SwitchesOffWhenMoreIsAskedThanItGives) {
  Battery battery(BatterySheet{}, 1.0);
  battery.Draw(1e5, Seconds(0.02));
  EXPECT_TRUE(battery.is_off());
}

TEST(Battery, HasLessVoltageAndEnergyWithoutSomeOfItsCells) {
  Battery whole(BatterySheet{}, 0.8), part(BatterySheet{}, 0.8);
  part.LoseCells(0.1);
  whole.Draw(80.0, kHour * 0.1);
  part.Draw(80.0, kHour * 0.1);
  EXPECT_NEAR(part.volts() / whole.volts(), 0.9, 0.01);
  EXPECT_NEAR((0.8 - part.charge()) / (0.8 - whole.charge()), 1.0 / 0.9, 0.01);
}

}  // namespace
}  // namespace limpet
