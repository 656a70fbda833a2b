// SPDX-License-Identifier: MIT
#include "limpet/imaging/lamp.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

Lamp LampOf(double power, double beam_deg = 45.0) {
  ImageParams::Light light;
  light.lamp = power;
  light.lamp_off = 0.0;
  light.lamp_beam = Radians::FromTextUnit(beam_deg);
  return {light, WaterColumn(Meters(8.0), {0.5, 1.0})};
}

TEST(Lamp, FallsWithTheSquareOfTheDistanceAndTheWater) {
  const Lamp lamp = LampOf(2.0);
  const WaterColumn water(Meters(8.0), {0.5, 1.0});
  const Eigen::Array3f near = lamp.LightAt({0.0, 0.0, 1.0});
  const Eigen::Array3f far = lamp.LightAt({0.0, 0.0, 3.0});
  EXPECT_LT((far - near / 9.0F * water.Direct(2.0)).abs().maxCoeff(), 1e-6);
  EXPECT_LT((near - 2.0F * water.Direct(1.0)).abs().maxCoeff(), 1e-6);
}

TEST(Lamp, BeamIsDownTo61PercentAtItsAngle) {
  const Lamp lamp = LampOf(1.0, 30.0);
  const double angle = RadiansFromDegrees(30.0);
  const Eigen::Array3f off =
      lamp.LightAt(2.0 * Eigen::Vector3d(std::sin(angle), 0.0, std::cos(angle)));
  EXPECT_NEAR(off(1) / lamp.LightAt({0.0, 0.0, 2.0})(1), std::exp(-0.5), 1e-6);
}

TEST(Lamp, VeilSaturatesWithinItsReach) {
  const Lamp lamp = LampOf(3.0);
  EXPECT_EQ(lamp.Veil(0.0).maxCoeff(), 0.0);
  EXPECT_GT(lamp.Veil(4.0)(1), lamp.Veil(1.0)(1));
  EXPECT_NEAR(lamp.Veil(11.0)(1), lamp.Veil(8.0)(1), 0.01 * lamp.Veil(8.0)(1));
  EXPECT_EQ(lamp.Veil(50.0)(1), lamp.Veil(100.0)(1));
}

TEST(Lamp, IsDarkWithoutPower) {
  EXPECT_FALSE(LampOf(0.0).is_on());
  EXPECT_EQ(LampOf(0.0).LightAt({0.0, 0.0, 1.0}).maxCoeff(), 0.0);
}

}  // namespace
}  // namespace limpet
