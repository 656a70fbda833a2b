// SPDX-License-Identifier: MIT
// How much of the water one place may decide, and how much all images together.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

class StatusWaterBounds : public ObjectStatusesTest {
 protected:
  /// Greatest change of the logarithm of the odds of two visibilities, from what was expected.
  [[nodiscard]] double MostChanged() const {
    const StatusParams params;
    const VisibilityBelief expected(params.detection.visibility, params.visibility_spread);
    const PerVisibility change = (statuses_.Water().chances() / expected.chances()).log();
    return change.maxCoeff() - change.minCoeff();
  }
};

TEST_F(StatusWaterBounds, NothingSeenChangesNothing) { EXPECT_NEAR(MostChanged(), 0.0, 1e-9); }

TEST_F(StatusWaterBounds, OnePlaceChangesNoOddsByMoreThanEToTheFifth) {
  const Real one{.object = At(4.0, 0.0), .landmark = 1};
  for (int pass = 0; pass < 3; ++pass)
    Fly(0.0, {one});
  Landmarks({one});
  EXPECT_NEAR(MostChanged(), 5.0, 1e-6) << "dozens of boxes that murk would not have shown";
}

TEST_F(StatusWaterBounds, TwoPlacesAreTwoWitnesses) {
  const std::vector<Real> both{{.object = At(0.0, 0.0), .landmark = 1},
                               {.object = At(8.0, 0.0), .landmark = 2}};
  for (int pass = 0; pass < 3; ++pass)
    Fly(0.0, both);
  Landmarks(both);
  EXPECT_NEAR(MostChanged(), 10.0, 1e-6);
}

TEST_F(StatusWaterBounds, AllImagesTogetherChangeNoOddsByMoreThanEToTheSixth) {
  for (double range = 0.3; range < 8.0; range += 0.25)
    statuses_.contrasts().Add(range, {.green = std::exp(-2.8 - 1.5 * range), .noise = 1e-9});
  EXPECT_NEAR(MostChanged(), 6.0, 1e-6) << "contrast fades as in water of 2 m";
}

}  // namespace
}  // namespace limpet
