// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_density.hpp"

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(SeenDensity, IsHighestWhereMostHasBeenSeen) {
  const HalfSeen scene;
  const SeenDensity density(scene.ground);
  EXPECT_GT(density.At({-9.5, 0.0}), 0.8);
  EXPECT_LT(density.At({10.0, 0.0}), 0.05);
}

TEST(SeenDensity, SamplesFallWhereLittleHasBeenSeen) {
  const HalfSeen scene;
  const SeenDensity density(scene.ground);
  Random random(7);
  int in_the_unseen_north = 0;
  for (int i = 0; i < 1000; ++i) {
    in_the_unseen_north += density.Sample(kSceneRegion, random).north > -2.0 ? 1 : 0;
  }
  EXPECT_GT(in_the_unseen_north, 700);  // 56 % of the region
}

}  // namespace
}  // namespace limpet::scene
