// SPDX-License-Identifier: MIT
#include "limpet/planning/paper_tree.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/planning/view_entropy.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

/// The branch with the most entropy (eq. 17).
const Option& MostInformative(const std::vector<Option>& branches, const Ground& ground) {
  return *std::ranges::max_element(
      branches, {}, [&ground](const Option& branch) { return MapEntropyOf(branch.views, ground); });
}

TEST(PaperTree, LeadsToViewsInsideTheRegion) {
  SurveyGrid grid(kArea);
  Ground ground(grid, TableFootprint());
  Random random(8);
  std::vector<Pose2> kept;
  Pose2 pose = kStart;
  for (int i = 0; i < 15; ++i) {
    ground.Update(grid);
    const auto branches = PaperTree(pose, kept, ground, kSceneRegion, {}, random);
    ASSERT_FALSE(branches.empty());
    const Option next = MostInformative(branches, ground);
    ASSERT_TRUE(kSceneRegion.Contains(next.path));
    EXPECT_LT(Distance(next.path.end(), next.views.front()), 1e-9);
    Fly(grid, next.path);
    pose = next.path.end();
    kept.assign(next.views.begin() + 1, next.views.end());
  }
  EXPECT_GT(grid.coverage().seabed, 0.3);
}

TEST(PaperTree, BeginsWithTheBranchThatWasKept) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, TableFootprint());
  const std::vector<Pose2> kept{{-12.5, -11.0, 0.5 * std::numbers::pi},
                                {-12.5, -7.0, 0.5 * std::numbers::pi}};
  Random random(8);
  const auto branches = PaperTree(kStart, kept, ground, kSceneRegion, {}, random);
  ASSERT_GE(branches.size(), 2U);
  ASSERT_EQ(branches[1].views.size(), 2U);
  EXPECT_LT(Distance(branches[1].views.back(), kept.back()), 1e-9);
}

}  // namespace
}  // namespace limpet::scene
