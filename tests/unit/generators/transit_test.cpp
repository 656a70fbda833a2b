// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/generators/half_surveyed.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

using scene::kRadius;
using ::testing::IsEmpty;

TEST(TransitGenerator, FindsTheWayInFromAnyStartOutside) {
  for (const double away : {5.0, 50.0, 120.0}) {
    for (int i = 0; i < 16; ++i) {
      const double bearing = 2.0 * std::numbers::pi * i / 16;
      const Pose2 start{(20.0 + away) * std::cos(bearing) * 1.5,
                        (20.0 + away) * std::sin(bearing) * 1.5, 0.7 * i};
      const HalfSurveyed survey(start);
      const std::vector<Option> ways = survey.OffersOf("transit");
      ASSERT_EQ(ways.size(), 1U);
      EXPECT_TRUE(survey.region().IsRecoverable(ways.front().path.end(), kRadius));
      EXPECT_LT(ways.front().path.length(), survey.region().Outside(start) + 25.0);
    }
  }
}

TEST(TransitGenerator, LeavesTheWayInToOthersWhereTheyKnowOne) {
  const HalfSurveyed survey({40.0, 0.0, 0.0});
  std::vector<Option> others = survey.OffersOf("transit");
  EXPECT_THAT(survey.OffersOf("transit", others), IsEmpty());
  others.front().source = "home";  // the way home is no way in
  EXPECT_EQ(survey.OffersOf("transit", others).size(), 1U);
}

}  // namespace
}  // namespace limpet
