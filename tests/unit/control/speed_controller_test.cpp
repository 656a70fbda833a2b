// SPDX-License-Identifier: MIT
#include "limpet/control/speed_controller.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/control/control_law.hpp"

namespace limpet {
namespace {

TEST(SpeedController, FeedsForwardTheDragOfASteadySpeed) {
  SpeedController speed({}, DefaultHydrodynamics());
  speed.Reset(0.5);
  EXPECT_NEAR(speed.Force({.lack = speed.Lack({0.5, 0.5}, kLawStep), .current = 0.0}),
              DragForce(DefaultHydrodynamics(), 0, 0.5), 1e-12);
}

TEST(SpeedController, RampsUpInsteadOfJumping) {
  SpeedController speed({}, DefaultHydrodynamics());
  speed.Reset(0.0);
  EXPECT_NEAR(speed.Lack({0.0, 1.0}, kLawStep), 0.025, 1e-12);
}

TEST(SpeedProperties, TheRampReachesAnySpeedInJustTheTimeThatItTakes) {
  Random random(6, "speed");
  const SpeedController::Gains gains;
  for (int run = 0; run < 100; ++run) {
    SpeedController speed(gains, DefaultHydrodynamics());
    const double from = random.Uniform(-0.5, 1.5), to = random.Uniform(-0.5, 1.5);
    speed.Reset(from);
    double reference = from;
    for (int step = 1; step <= 120; ++step) {
      const double next = speed.Lack({0.0, to}, 0.1);  // of a vehicle that stands
      EXPECT_LE(std::abs(next - reference), 0.1 * gains.max_acceleration + 1e-12);
      reference = next;
      const bool is_due = 0.1 * step * gains.max_acceleration >= std::abs(to - from);
      EXPECT_EQ(std::abs(reference - to) < 1e-9, is_due) << step;
    }
  }
}

}  // namespace
}  // namespace limpet
