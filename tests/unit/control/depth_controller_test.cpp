// SPDX-License-Identifier: MIT
#include "limpet/control/depth_controller.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/control/control_law.hpp"

namespace limpet {
namespace {

TEST(DepthController, LeavesTheVehicleToItsBuoyancyAtTheSurface) {
  DepthController depth({}, DefaultHydrodynamics());
  EXPECT_EQ(depth.Update({.depth = 0.13, .depth_rate = 0.0, .desired_depth = 0.0}, kLawStep, false),
            0.0);
}

TEST(DepthController, HoldsTheNetBuoyancyDownAtDepth) {
  DepthController depth({}, DefaultHydrodynamics());
  depth.Reset(3.0);
  EXPECT_NEAR(
      depth.Update({.depth = 3.0, .depth_rate = 0.0, .desired_depth = 3.0}, kLawStep, false),
      VehicleParams{}.net_buoyancy_n, 1e-9);
}

TEST(DepthController, AsksForNoLeapWhenTheWantedDepthJumps) {
  DepthController depth({}, DefaultHydrodynamics());
  depth.Reset(3.0);
  const double force =
      depth.Update({.depth = 3.0, .depth_rate = 0.0, .desired_depth = 13.0}, kLawStep, false);
  EXPECT_LT(force, 20.0);
}

TEST(DepthProperties, AsksForNothingAtTheSurfaceAndNeverForALeap) {
  Random random(9, "depth");
  for (int run = 0; run < 30; ++run) {
    DepthController depth({}, DefaultHydrodynamics());
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
