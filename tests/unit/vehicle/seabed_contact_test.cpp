// SPDX-License-Identifier: MIT
// What the seabed may do to the skids, whatever the vehicle does on it.
#include "limpet/vehicle/seabed_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kFlat = 10.0;  // depth of a level seabed [m]
double FlatSeabed(const Eigen::Vector2d&) { return kFlat; }

/// The vehicle upright with its skids this far under the seabed [m].
ContactState Pressed(double penetration) {
  const double height = ContactParams{}.skids_B.front().z();
  return {.p_WB = {3.0, -2.0, kFlat + penetration - height},
          .R_WB = Eigen::Matrix3d::Identity(),
          .v_WB_W = Eigen::Vector3d::Zero(),
          .omega_B = Eigen::Vector3d::Zero()};
}

TEST(SoftPenetration, IsTheDepthDeepInNothingHighAboveAndNeverBelowEither) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const double width = random.Uniform(1e-4, 0.1), depth = random.Uniform(-50.0, 50.0) * width;
    const double soft = SoftPenetration(depth, width);
    EXPECT_GE(soft, std::max(depth, 0.0));
    EXPECT_LE(soft, std::max(depth, 0.0) + width * std::log(2.0) + 1e-12);
    EXPECT_GE(SoftPenetration(depth + width, width), soft);
  }
  EXPECT_NEAR(SoftPenetration(0.0, 0.01), 0.01 * std::log(2.0), 1e-12);
}

TEST(SoftPenetration, HasNoStepWhereItsRoundingIsLeftOut) {
  constexpr double kWidth = 0.004;
  EXPECT_NEAR(SoftPenetration(40.0 * kWidth * (1.0 - 1e-9), kWidth),
              SoftPenetration(40.0 * kWidth * (1.0 + 1e-9), kWidth), 1e-9);
}

TEST(SeabedContact, FarAboveTheSeabedIsNoneAtAll) {
  EXPECT_TRUE(SeabedContactWrench({}, FlatSeabed, Pressed(-1.0)).isZero(0.0));
}

TEST(SeabedContact, HoldsARestingVehicleWithTheForceOfItsSkidsSprings) {
  const ContactParams params;
  const Wrench wrench = SeabedContactWrench(params, FlatSeabed, Pressed(0.02));
  // Damping of a skid at rest is rounded to very nearly one.
  EXPECT_NEAR(wrench(2), -4.0 * params.stiffness_n_per_m * SoftPenetration(0.02, params.softness_m),
              0.01);
  EXPECT_NEAR(wrench(0), 0.0, 1e-9);
  EXPECT_NEAR(wrench(3), 0.0, 1e-9) << "skids are symmetric";
  EXPECT_NEAR(wrench(4), 0.0, 1e-9);
}

class SeabedContactProperties : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] ContactState DrawTouch() {
    ContactState state = Pressed(random_.Uniform(-0.03, 0.03));
    state.R_WB = RotationFromRollPitchYaw(random_.Normal(0.05), random_.Normal(0.05),
                                          random_.Uniform(-3.1, 3.1));
    state.v_WB_W = {random_.Normal(0.3), random_.Normal(0.3), random_.Normal(0.3)};
    state.omega_B = {random_.Normal(0.3), random_.Normal(0.3), random_.Normal(0.3)};
    return state;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "contact"};
};

TEST_P(SeabedContactProperties, NeverPullsTheVehicleDown) {
  for (int i = 0; i < 100; ++i) {
    const ContactState state = DrawTouch();
    const Wrench wrench = SeabedContactWrench({}, FlatSeabed, state);
    EXPECT_LE((state.R_WB * wrench.head<3>()).z(), 0.0);
  }
}

TEST_P(SeabedContactProperties, FrictionIsAgainstTheMotionAndAtMostItsShareOfTheLoad) {
  const ContactParams params;
  for (int i = 0; i < 100; ++i) {
    ContactState state = DrawTouch();
    state.omega_B.setZero();  // all skids then slide alike
    const Eigen::Vector3d force_W =
        state.R_WB * SeabedContactWrench(params, FlatSeabed, state).head<3>();
    EXPECT_LE(force_W.head<2>().dot(state.v_WB_W.head<2>()), 0.0);
    EXPECT_LE(force_W.head<2>().norm(), params.friction * -force_W.z() + 1e-9);
  }
}

TEST_P(SeabedContactProperties, HoldsHarderWhatComesDownThanWhatLifts) {
  for (int i = 0; i < 50; ++i) {
    ContactState down = DrawTouch();
    down.omega_B.setZero();
    down.v_WB_W = {0.0, 0.0, random_.Uniform(0.01, 0.3)};
    ContactState up = down;
    up.v_WB_W = -down.v_WB_W;
    const auto load = [](const ContactState& state) {
      return -(state.R_WB * SeabedContactWrench({}, FlatSeabed, state).head<3>()).z();
    };
    EXPECT_GT(load(down), load(up));
  }
}

TEST_P(SeabedContactProperties, IsTheSameOnEveryPartOfALevelSeabed) {
  for (int i = 0; i < 50; ++i) {
    const ContactState here = DrawTouch();
    const Eigen::Matrix3d turn = RotationFromRollPitchYaw(0.0, 0.0, random_.Uniform(-3.0, 3.0));
    ContactState there = here;
    there.p_WB = turn * here.p_WB + Eigen::Vector3d(random_.Normal(9.0), random_.Normal(9.0), 0.0);
    there.R_WB = turn * here.R_WB;
    there.v_WB_W = turn * here.v_WB_W;
    const Wrench one = SeabedContactWrench({}, FlatSeabed, here);
    EXPECT_LT((one - SeabedContactWrench({}, FlatSeabed, there)).norm(), 1e-8 * (1.0 + one.norm()));
  }
}

TEST_P(SeabedContactProperties, HasNoKinkThatASolverCouldMeet) {
  for (int i = 0; i < 50; ++i) {
    ContactState state = DrawTouch();
    const auto at = [&](double down) {
      ContactState moved = state;
      moved.p_WB.z() += down;
      return SeabedContactWrench({}, FlatSeabed, moved);
    };
    constexpr double kStep = 1e-6;
    const Wrench forth = (at(kStep) - at(0.0)) / kStep, back = (at(0.0) - at(-kStep)) / kStep;
    EXPECT_LT((forth - back).norm(), 1e-2 * (10.0 + forth.norm()));
  }
}

TEST_P(SeabedContactProperties, LiftsTheSideThatStandsOnAStone) {
  ContactState state = Pressed(0.0);
  const auto stone = [](const Eigen::Vector2d& p_W) {
    return kFlat + (p_W.y() > -2.0 ? -0.01 : 0.05);
  };
  const Wrench wrench = SeabedContactWrench({}, stone, state);
  EXPECT_LT(wrench(3), 0.0) << "starboard is pushed up: it rolls to port";
  EXPECT_NEAR(wrench(4), 0.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, SeabedContactProperties, ::testing::Range(1, 6));

}  // namespace
}  // namespace limpet
