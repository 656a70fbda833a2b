// SPDX-License-Identifier: MIT
#include "limpet/planning/target_tour.hpp"

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(TargetTours, PassesEveryFormerObjectOfTable1Early) {
  Objective objective;
  for (const auto& [north, east] :
       {std::pair{4.0, 1.0}, std::pair{2.0, 10.0}, std::pair{6.0, -3.0}, std::pair{-6.0, -5.0}}) {
    objective.targets.push_back({.north = north, .east = east, .window = {1.5, 1.5}, .value = 1.0});
  }
  objective.target_decay_m = 1e9;
  const std::vector<Option> tours = TargetTours(kStart, kSceneRegion, objective, kRadius);
  ASSERT_EQ(tours.size(), 1U);
  EXPECT_NEAR(TargetValueOf(tours.front().path, objective), 4.0, 1e-6);
  EXPECT_LT(tours.front().path.length(), 45.0);
  EXPECT_TRUE(kSceneRegion.Contains(tours.front().path));
}

TEST(TargetTours, GoOnBeyondTheFirstEightStops) {
  const Objective objective = ManyTargets(5, 6);
  const std::vector<Option> tours = TargetTours(kStart, kSceneRegion, objective, kRadius);
  ASSERT_EQ(tours.size(), 4U);
  EXPECT_NEAR(TargetValueOf(tours.back().path, objective), 30 * 5.0, 1.0);
  EXPECT_TRUE(kSceneRegion.Contains(tours.back().path));
}

TEST(TargetTours, EndWhereALookIsWorthNothingAnyMore) {
  Objective objective = ManyTargets(5, 6);
  objective.target_decay_m = 20.0;
  EXPECT_EQ(TargetTours(kStart, kSceneRegion, objective, kRadius).size(), 1U);
}

TEST(TargetTours, LookFromTheBorderAtWhatLiesBeyondIt) {
  const Target beside{.north = 18.5, .east = 0.0, .window = {1.0, 2.0}};  // 1.5 m outside
  EXPECT_TRUE(CanBeLookedAt(beside, kSceneRegion, kRadius));
  const Target beyond{.north = 20.0, .east = 0.0, .window = {1.0, 2.0}};
  EXPECT_FALSE(CanBeLookedAt(beyond, kSceneRegion, kRadius));
}

TEST(TargetTours, IsNothingWithoutTargets) {
  EXPECT_TRUE(TargetTours(kStart, kSceneRegion, Objective{}, kRadius).empty());
}

}  // namespace
}  // namespace limpet::scene
