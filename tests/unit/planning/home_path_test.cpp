// SPDX-License-Identifier: MIT
#include "limpet/planning/home_path.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(HomePath, EndsAtHomeAndStaysInside) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Pose2 start{random.Uniform(-12.0, 12.0), random.Uniform(-15.0, 15.0),
                      random.Uniform(-std::numbers::pi, std::numbers::pi)};
    const Option home = HomePath(start, {-12.5, -15.5}, kSceneRegion, kRadius);
    EXPECT_NEAR(home.path.end().north, -12.5, 1e-6);
    EXPECT_NEAR(home.path.end().east, -15.5, 1e-6);
    EXPECT_TRUE(kSceneRegion.Contains(home.path));
  }
}

TEST(HomePath, OnItsWayOutItDoesNotTurnBackForThePlaceWhereItLeaves) {
  const Region region(Basin(), Meters(0.4));
  const double eastwards = 0.5 * std::numbers::pi;
  for (const double east : {20.0, 23.0, 25.0, 26.3, 28.0, 30.0}) {
    const Option home = HomePath({-10.2, east, eastwards}, {12.0, 36.0}, region, kRadius);
    EXPECT_LT(home.path.length(), (36.0 - east) + 12.2 + 10.3 + 3.0) << east;
  }
}

TEST(HomePath, IsNotMuchLongerThanTheStraightLine) {
  const Option home = HomePath({10.0, 10.0, 0.0}, {-12.5, -15.5}, kSceneRegion, kRadius);
  EXPECT_LT(home.path.length(), std::hypot(22.5, 25.5) + 12.0);
}

}  // namespace
}  // namespace limpet::scene
