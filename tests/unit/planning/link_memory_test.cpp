// SPDX-License-Identifier: MIT
#include "limpet/planning/link_memory.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

Pose2 DrawPose(Random& random) {
  return {random.Uniform(-14.0, 14.0), random.Uniform(-14.0, 14.0), random.Uniform(-3.0, 3.0)};
}

void ExpectSameLink(const PassLink& a, const PassLink& b) {
  EXPECT_EQ(a.is_inside, b.is_inside);
  EXPECT_EQ(a.word.length, b.word.length);
  for (std::size_t i = 0; i < a.word.segments.size(); ++i) {
    EXPECT_EQ(a.word.segments[i].curvature, b.word.segments[i].curvature);
    EXPECT_EQ(a.word.segments[i].length, b.word.segments[i].length);
  }
}

/// Many more pairs than it has places for: what falls into the same place must not be mistaken.
TEST(LinkMemory, AnswersAsIfItHadForgottenAll) {
  Random random(3);
  LinkMemory memory(scene::kSceneRegion, scene::kRadius);
  std::vector<Pose2> poses;
  for (int i = 0; i < 90; ++i)
    poses.push_back(DrawPose(random));
  for (int i = 0; i < 20000; ++i) {
    const Pose2& from = poses[random.Index(poses.size())];
    const Pose2& to = poses[random.Index(poses.size())];
    ExpectSameLink(memory.Between(from, to),
                   LinkBetween(from, to, scene::kSceneRegion, scene::kRadius));
  }
}

TEST(LinkMemory, TellsAWayFromTheWayBackAndAHeadingFromItsNeighbour) {
  LinkMemory memory(scene::kSceneRegion, scene::kRadius);
  const Pose2 a{-5.0, 2.0, 0.3}, b{4.0, -1.0, 2.0};
  Pose2 b_turned = b;
  b_turned.yaw += 1e-12;
  for (int round = 0; round < 2; ++round) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a), std::pair(a, b_turned)}) {
      ExpectSameLink(memory.Between(from, to),
                     LinkBetween(from, to, scene::kSceneRegion, scene::kRadius));
    }
  }
}

}  // namespace
}  // namespace limpet
