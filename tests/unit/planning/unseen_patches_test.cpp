// SPDX-License-Identifier: MIT
#include "limpet/planning/unseen_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

/// Table 1's area, flown in lanes that leave a strip between two of them out.
class UnseenPatchesTest : public ::testing::Test {
 protected:
  void FlyLanes(double skip_from, double skip_to) {
    for (double north = -16.0; north <= 16.0; north += 1.0) {
      if (north > skip_from && north < skip_to) continue;
      scene::Fly(grid_, DubinsPath({north, -20.0, 0.5 * std::numbers::pi}, {{0.0, 40.0}}));
    }
    ground_.Update(grid_);
  }
  [[nodiscard]] static double Sum(const std::vector<Patch>& patches) {
    double sum = 0.0;
    for (const Patch& patch : patches)
      sum += patch.unseen_m2;
    return sum;
  }
  SurveyGrid grid_{scene::kArea};
  Ground ground_{grid_, scene::TableFootprint()};
};

TEST_F(UnseenPatchesTest, BeforeTheDiveAreTheWholeArea) {
  ground_.Update(grid_);
  const std::vector<Patch> patches = UnseenPatches(ground_, 6.0);
  EXPECT_NEAR(Sum(patches), 30.0 * 36.0, 1.0);
  for (const Patch& patch : patches)
    EXPECT_NEAR(patch.missing_m2, patch.unseen_m2, 0.1);
}

TEST_F(UnseenPatchesTest, AreNoneWhereEverythingWasSeen) {
  FlyLanes(100.0, 101.0);
  EXPECT_NEAR(Sum(UnseenPatches(ground_, 6.0)), 0.0, 1e-9);
}

TEST_F(UnseenPatchesTest, OfASkippedStripLieInItAlongIt) {
  FlyLanes(-6.0, 6.0);
  const std::vector<Patch> patches = UnseenPatches(ground_, 6.0);
  ASSERT_FALSE(patches.empty());
  EXPECT_GT(Sum(patches), 50.0);
  for (const Patch& patch : patches) {
    EXPECT_LT(std::abs(patch.north), 6.5);
    EXPECT_GE(patch.length, patch.width - 1e-9);
    EXPECT_LE(patch.unseen_m2, patch.length * patch.width + 1.0);
    EXPECT_LE(patch.missing_m2, patch.unseen_m2 + 1e-9);
  }
}

TEST_F(UnseenPatchesTest, ComeMostMissingFirst) {
  FlyLanes(-6.0, 4.0);
  const std::vector<Patch> patches = UnseenPatches(ground_, 5.0);
  EXPECT_TRUE(std::ranges::is_sorted(patches, std::ranges::greater{}, &Patch::missing_m2));
}

TEST_F(UnseenPatchesTest, HoldEveryUnseenCellWhateverTheTilesAre) {
  FlyLanes(-5.0, 5.0);
  const double reference = Sum(UnseenPatches(ground_, 6.0));
  for (const double tile : {2.0, 4.5, 9.0, 50.0})
    EXPECT_NEAR(Sum(UnseenPatches(ground_, tile)), reference, 1e-6);
}

}  // namespace
}  // namespace limpet
