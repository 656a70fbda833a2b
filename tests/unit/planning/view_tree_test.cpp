// SPDX-License-Identifier: MIT
#include "limpet/planning/view_tree.hpp"

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(ViewTree, OffersPathsThatStayInsideAndRecoverable) {
  const HalfSeen scene;
  Random random(4);
  const auto offers = ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, random);
  ASSERT_FALSE(offers.empty());
  for (const Option& option : offers) {
    EXPECT_TRUE(kSceneRegion.Contains(option.path));
    EXPECT_TRUE(kSceneRegion.IsRecoverable(option.path.end(), kRadius));
  }
}

TEST(ViewTree, ItsEstimateIsTheObjectiveOfItsPath) {
  const HalfSeen scene;
  const Objective objective = Defaults();
  Random random(5);
  SeenAlong seen(scene.ground);
  for (const Option& option : ViewTree(kStart, scene.ground, kSceneRegion, objective, {}, random)) {
    EXPECT_NEAR(option.estimate, ValueOf(option.path, objective, scene.ground, seen), 1.5);
  }
}

TEST(ViewTree, IsDeterministicForASeed) {
  const HalfSeen scene;
  Random one(6), two(6);
  ExpectSame(ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, one),
             ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, two));
}

TEST(ViewTree, OffersNoPathTwice) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    NearlySeen scene;
    Random random(seed);
    const auto offers = ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, random);
    for (std::size_t i = 0; i < offers.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Pose2 one = offers[i].path.end(), other = offers[j].path.end();
        EXPECT_FALSE(one.north == other.north && one.east == other.east &&
                     offers[i].path.length() == offers[j].path.length())
            << "seed " << seed << ", " << offers[i].path.length() << " m, worth "
            << offers[i].estimate;
      }
    }
  }
}

TEST(ViewTree, RewiringDoesNotMakeTheBestBranchWorse) {
  const HalfSeen scene;
  double with = 0.0, without = 0.0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Random one(seed), two(seed);
    with += ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, one).front().estimate;
    ViewTreeParams plain;
    plain.rewire_radius = Meters(0.0);
    without +=
        ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), plain, two).front().estimate;
  }
  EXPECT_GE(with, without - 1.0);
}

}  // namespace
}  // namespace limpet::scene
