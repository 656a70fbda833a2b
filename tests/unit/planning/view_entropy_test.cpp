// SPDX-License-Identifier: MIT
#include "limpet/planning/view_entropy.hpp"

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(ViewEntropy, CountsEachViewByItselfAsPrinted) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, TableFootprint());
  const Pose2 view{0.0, 0.0, 0.0};
  const double once = MapEntropyOf(std::vector{view}, ground);
  EXPECT_GT(once, 0.0);
  EXPECT_DOUBLE_EQ(MapEntropyOf(std::vector{view, view}, ground), 2.0 * once);
}

TEST(ViewEntropy, IsLessWhereTheGroundHasBeenSeen) {
  const HalfSeen scene;
  EXPECT_LT(MapEntropyOf(std::vector{Pose2{-9.5, 0.0, 0.0}}, scene.ground),
            0.3 * MapEntropyOf(std::vector{Pose2{9.5, 0.0, 0.0}}, scene.ground));
}

TEST(ViewEntropy, InheritsObjectsOfTheFormerSessionUntilTheyAreLookedAt) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, TableFootprint());
  OpiBelief former;
  former.former_id = 1;
  former.object.p_W = {-12.0, -10.0, 6.5};
  former.posterior = {.confirmed = 0.6, .removed = 0.4};
  const std::vector<Pose2> views{{-12.0, -10.0, 0.0}};
  const ObjectEntropy unseen = ObjectEntropyOf(views, ground, std::vector{former});
  EXPECT_GT(unseen.inherited, 0.0);
  EXPECT_EQ(unseen.seen, 0.0);
  former.looks = 1;
  const ObjectEntropy seen = ObjectEntropyOf(views, ground, std::vector{former});
  EXPECT_EQ(seen.inherited, 0.0);
  EXPECT_GT(seen.seen, 0.0);
}

}  // namespace
}  // namespace limpet::scene
