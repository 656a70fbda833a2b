// SPDX-License-Identifier: MIT
#include "limpet/planning/gap_paths.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(GapPaths, ReachAPatchFarBeyondTheBeamsHorizon) {
  SurveyGrid grid(kArea);
  for (double north = -15.0; north <= 15.5; north += 2.0) {
    // All lanes but the last 6 m of the most north-eastern ones.
    const double length = north > 11.0 ? 30.0 : 36.0;
    Fly(grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, length}}));
  }
  const Ground ground(grid, TableFootprint());
  const auto offers = GapPaths(kStart, ground, kSceneRegion, Defaults(), {.finish_share = 1.0});
  ASSERT_FALSE(offers.empty());
  SeenAlong seen(ground);
  EXPECT_GT(seen(offers.front().path).new_area, 1.0);
  EXPECT_TRUE(kSceneRegion.Contains(offers.front().path));
}

TEST(GapPaths, OfferNothingWhenAllIsSeen) {
  SurveyGrid grid(kArea);
  for (double north = -15.0; north <= 15.5; north += 2.0) {
    Fly(grid, DubinsPath({north, -20.0, 0.5 * std::numbers::pi}, {{0.0, 40.0}}));
  }
  const Ground ground(grid, TableFootprint());
  EXPECT_TRUE(GapPaths(kStart, ground, kSceneRegion, Defaults(), {}).empty());
}

}  // namespace
}  // namespace limpet::scene
