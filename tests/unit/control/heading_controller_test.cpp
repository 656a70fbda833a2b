// SPDX-License-Identifier: MIT
// Signs and limits; and port and starboard are alike, as are all courses.
#include "limpet/control/heading_controller.hpp"

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/control/control_law.hpp"

namespace limpet {
namespace {

double YawMoment(double yaw, double desired) {
  HeadingController heading({}, DefaultHydrodynamics());
  HeadingController::Input input;
  input.yaw = yaw;
  input.desired_yaw = desired;
  return heading.Update(input, kLawStep, false);
}

TEST(HeadingController, TurnsTheShortWayAcrossSouth) {
  EXPECT_GT(YawMoment(3.0, -3.0), 0.0);
  EXPECT_LT(YawMoment(-3.0, 3.0), 0.0);
}

TEST(HeadingController, AsksForNoMoreThanItsGreatestTurnRate) {
  EXPECT_DOUBLE_EQ(YawMoment(0.0, 1.0), YawMoment(0.0, 2.0));
}

TEST(HeadingController, OnAnArcFlownPerfectlyAsksForItsDragAlone) {
  HeadingController heading({}, DefaultHydrodynamics());
  HeadingController::Input input;
  input.yaw_rate = input.desired_turn_rate = 0.167;
  EXPECT_NEAR(heading.Update(input, kLawStep, false), DragForce(DefaultHydrodynamics(), 5, 0.167),
              1e-12);
}

TEST(HeadingSymmetry, TheMirroredErrorAsksForTheMirroredMoment) {
  Random random(1, "heading");
  HeadingController starboard({}, DefaultHydrodynamics()), port({}, DefaultHydrodynamics());
  for (int step = 0; step < 300; ++step) {
    const HeadingController::Input input{.yaw = random.Uniform(-3.1, 3.1),
                                         .yaw_rate = random.Uniform(-0.5, 0.5),
                                         .desired_yaw = random.Uniform(-3.1, 3.1),
                                         .desired_turn_rate = random.Uniform(-0.2, 0.2),
                                         .u_water = random.Uniform(0.0, 1.0),
                                         .v_water = random.Uniform(-0.3, 0.3)};
    const HeadingController::Input mirrored{.yaw = -input.yaw,
                                            .yaw_rate = -input.yaw_rate,
                                            .desired_yaw = -input.desired_yaw,
                                            .desired_turn_rate = -input.desired_turn_rate,
                                            .u_water = input.u_water,
                                            .v_water = -input.v_water};
    EXPECT_NEAR(starboard.Update(input, 0.1, false), -port.Update(mirrored, 0.1, false), 1e-9);
  }
}

TEST(HeadingSymmetry, NorthIsAsGoodAsAnyCourse) {
  Random random(2, "heading");
  const double turn = 2.5;
  HeadingController here({}, DefaultHydrodynamics()), turned({}, DefaultHydrodynamics());
  for (int step = 0; step < 300; ++step) {
    HeadingController::Input input{.yaw = random.Uniform(-3.1, 3.1),
                                   .yaw_rate = random.Uniform(-0.5, 0.5),
                                   .desired_yaw = random.Uniform(-3.1, 3.1)};
    const double moment = here.Update(input, 0.1, false);
    input.yaw = WrapAngle(input.yaw + turn);
    input.desired_yaw = WrapAngle(input.desired_yaw + turn);
    EXPECT_NEAR(turned.Update(input, 0.1, false), moment, 1e-9);
  }
}

}  // namespace
}  // namespace limpet
