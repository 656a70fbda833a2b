// SPDX-License-Identifier: MIT
// Signs and limits; and port and starboard are alike.
#include "limpet/control/sway_controller.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/control/control_law.hpp"

namespace limpet {
namespace {

TEST(SwayController, PushesAgainstSideslipAndIntoATurn) {
  const SwayController sway({}, DefaultHydrodynamics());
  SwayController::Input input;
  input.v = 0.1;
  EXPECT_LT(sway.Force(input), 0.0);
  input = {};
  input.u = 0.5;
  input.turn_rate = 0.167;
  EXPECT_GT(sway.Force(input), 3.0);
}

TEST(SwayController, HoldsAgainstACurrentFromTheSide) {
  const SwayController sway({}, DefaultHydrodynamics());
  SwayController::Input input;
  input.current_v = 0.1;
  EXPECT_NEAR(sway.Force(input), -DragForce(DefaultHydrodynamics(), 1, 0.1), 1e-12);
}

TEST(SwaySymmetry, TheMirroredMotionAsksForTheMirroredForceWithinItsLimit) {
  Random random(3, "sway");
  const SwayController::Gains gains;
  const SwayController sway(gains, DefaultHydrodynamics());
  for (int run = 0; run < 500; ++run) {
    const SwayController::Input input{.u = random.Uniform(-1.0, 2.0),
                                      .v = random.Uniform(-1.0, 1.0),
                                      .turn_rate = random.Uniform(-0.5, 0.5),
                                      .current_u = random.Uniform(-0.5, 0.5),
                                      .current_v = random.Uniform(-0.5, 0.5)};
    const SwayController::Input mirrored{.u = input.u,
                                         .v = -input.v,
                                         .turn_rate = -input.turn_rate,
                                         .current_u = input.current_u,
                                         .current_v = -input.current_v};
    EXPECT_NEAR(sway.Force(input), -sway.Force(mirrored), 1e-9);
    EXPECT_LE(std::abs(sway.Force(input)), gains.max_force);
  }
}

}  // namespace
}  // namespace limpet
