// SPDX-License-Identifier: MIT
// Port and starboard are alike, and so are both ways of every axis: a control law that prefers one
// side has a sign wrong somewhere.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/control/depth_controller.hpp"
#include "limpet/control/drift_estimate.hpp"
#include "limpet/control/heading_controller.hpp"
#include "limpet/control/integral_term.hpp"
#include "limpet/control/speed_controller.hpp"
#include "limpet/control/sway_controller.hpp"
#include "limpet/control/thrust_allocation.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Hydrodynamics Derived() { return DeriveHydrodynamics(VehicleParams{}); }

TEST(HeadingSymmetry, TheMirroredErrorAsksForTheMirroredMoment) {
  Random random(1, "heading");
  HeadingController starboard({}, Derived()), port({}, Derived());
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
  HeadingController here({}, Derived()), turned({}, Derived());
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

TEST(SwaySymmetry, TheMirroredMotionAsksForTheMirroredForceWithinItsLimit) {
  Random random(3, "sway");
  const SwayController::Gains gains;
  const SwayController sway(gains, Derived());
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

TEST(DriftSymmetry, ACurrentLearnedOnOneCourseIsTheSameCurrentOnEveryOther) {
  Random random(4, "drift");
  for (int run = 0; run < 100; ++run) {
    DriftEstimate drift({});
    const double yaw = random.Uniform(-3.1, 3.1);
    Eigen::Vector2d current_B;
    for (int step = 0; step < 30; ++step) {
      current_B =
          drift.Update(yaw, {random.Uniform(-0.2, 0.2), random.Uniform(-0.2, 0.2)}, 0.1, false);
    }
    const Eigen::Vector2d current_W = Eigen::Rotation2Dd(yaw) * current_B;
    const double other = random.Uniform(-3.1, 3.1);
    const Eigen::Vector2d there = drift.Update(other, Eigen::Vector2d::Zero(), 0.1, false);
    EXPECT_LT((Eigen::Rotation2Dd(other) * there - current_W).norm(), 1e-9);
    EXPECT_LE(current_W.norm(), DriftEstimate::Gains{}.limit + 1e-9);
  }
}

TEST(IntegralProperties, NeverLeaveTheirLimitNorGrowWhileActuatorsSaturate) {
  Random random(5, "integral");
  for (int run = 0; run < 50; ++run) {
    IntegralTerm integral(random.Uniform(0.1, 2.0), 0.5);
    for (int step = 0; step < 200; ++step) {
      const double before = std::abs(integral.value());
      const bool is_saturated = random.Chance(0.4);
      const double value = integral.Update(random.Uniform(-3.0, 3.0), 0.1, is_saturated);
      EXPECT_LE(std::abs(value), 0.5);
      if (is_saturated) {
        EXPECT_LE(std::abs(value), before);
      }
    }
  }
}

TEST(SpeedProperties, TheRampReachesAnySpeedInJustTheTimeThatItTakes) {
  Random random(6, "speed");
  const SpeedController::Gains gains;
  for (int run = 0; run < 100; ++run) {
    SpeedController speed(gains, Derived());
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

TEST(AllocationSymmetry, TheOppositeWrenchIsMadeByOppositeThrust) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  Random random(7, "thrust");
  for (int run = 0; run < 300; ++run) {
    Wrench wanted = 40.0 * Wrench::NullaryExpr([&random] { return random.Uniform(-1.0, 1.0); });
    wanted(3) = 0.0;
    const auto there = allocation.Allocate(wanted), back = allocation.Allocate(-wanted);
    EXPECT_LT((there.command + back.command).norm(), 1e-12);
    EXPECT_EQ(there.is_saturated, back.is_saturated);
    EXPECT_LE(there.command.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
    EXPECT_LT((ThrusterLayout{}.WrenchPerThrust() * there.command * ThrusterLayout{}.max_thrust_n -
               there.achieved)
                  .norm(),
              1e-9)
        << "what is said to be achieved is what these commands make";
  }
}

TEST(AllocationSymmetry, NothingIsMadeThatWasNotAskedFor) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  Random random(8, "thrust");
  for (int run = 0; run < 300; ++run) {
    Wrench wanted = 60.0 * Wrench::NullaryExpr([&random] { return random.Uniform(-1.0, 1.0); });
    wanted(3) = 0.0;
    const auto made = allocation.Allocate(wanted).achieved;
    for (int axis = 0; axis < 6; ++axis) {
      EXPECT_GE(made(axis) * wanted(axis), -1e-9) << "never the other way";
      EXPECT_LE(std::abs(made(axis)), std::abs(wanted(axis)) + 1e-9) << "never more";
    }
  }
}

TEST(DepthProperties, AsksForNothingAtTheSurfaceAndNeverForALeap) {
  Random random(9, "depth");
  for (int run = 0; run < 30; ++run) {
    DepthController depth({}, Derived());
    depth.Reset(0.0);
    double before =
        depth.Update({.depth = 0.0, .depth_rate = 0.0, .desired_depth = 0.0}, 0.1, false);
    EXPECT_EQ(before, 0.0) << "buoyancy holds it";
    depth.Reset(5.0);
    before = depth.Update({.depth = 5.0, .depth_rate = 0.0, .desired_depth = 5.0}, 0.1, false);
    const double wanted = random.Uniform(1.0, 30.0);
    const double after =
        depth.Update({.depth = 5.0, .depth_rate = 0.0, .desired_depth = wanted}, 0.1, false);
    EXPECT_EQ(after >= before, wanted >= 5.0) << wanted;
  }
}

}  // namespace
}  // namespace limpet
