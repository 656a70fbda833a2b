// SPDX-License-Identifier: MIT
#include "limpet/simulation/upright_body.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using Eigen::Vector3d;

const UprightBody kColumn = UprightBody::Column({10.0, 0.0}, {.radius = 0.5, .top = 2.0});
const UprightBody kBox = UprightBody::Box({10.0, 0.0}, {1.0, 3.0}, 2.0);

TEST(UprightBody, SoundMeetsAWallHeadOn) {
  EXPECT_NEAR(*kColumn.Range({0, 0, 4}, {1, 0, 0}), 9.5, 1e-12);
  EXPECT_NEAR(*kBox.Range({0, 2.9, 4}, {1, 0, 0}), 9.0, 1e-12);
}

TEST(UprightBody, SoundPassesBesideItAndOverItAndNeverBackwards) {
  EXPECT_FALSE(kColumn.Range({0, 0.6, 4}, {1, 0, 0}));
  EXPECT_FALSE(kBox.Range({0, 3.1, 4}, {1, 0, 0}));
  EXPECT_FALSE(kBox.Range({0, 0, 1.9}, {1, 0, 0}));
  EXPECT_FALSE(kBox.Range({20, 0, 4}, {1, 0, 0}));
  // Over the near edge of the top and down onto it.
  EXPECT_NEAR(*kBox.Range({8, 0, 0}, Vector3d(1, 0, 1).normalized()), 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(UprightBody, SoundFromAboveMeetsItsTop) {
  EXPECT_NEAR(*kColumn.Range({10.2, 0, 0.5}, {0, 0, 1}), 1.5, 1e-12);
  EXPECT_FALSE(kColumn.Range({10.6, 0, 0.5}, {0, 0, 1}));
  EXPECT_FALSE(kColumn.Range({10, 0, 0.5}, {0, 0, -1}));
}

TEST(UprightBody, AVehicleWithinTouchesIt) {
  EXPECT_EQ(*kColumn.Range({10, 0, 3}, {1, 0, 0}), 0.0);
  EXPECT_EQ(kColumn.Distance({10.3, 0.3, 3}), 0.0);
  EXPECT_NEAR(kColumn.Distance({12, 0, 3}), 1.5, 1e-12);
  EXPECT_NEAR(kBox.Distance({12, 4, 3}), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(kBox.Distance({10, 0, 0.5}), 1.5, 1e-12);
  EXPECT_TRUE(kBox.Covers({10.9, -2.9}));
  EXPECT_FALSE(kBox.Covers({10.9, -3.1}));
}

TEST(UprightBody, HidesWhatLiesBehindIt) {
  EXPECT_TRUE(kColumn.IsBetween({0, 0, 3}, {20, 0, 7}));
  EXPECT_FALSE(kColumn.IsBetween({0, 0, 3}, {9, 0, 7}));
  EXPECT_FALSE(kColumn.IsBetween({0, 0, 0}, {20, 0, 1.9}));
}

/// Whatever the ray: where it is said to end is on the body, and nothing before that is in it.
TEST(UprightBody, EveryRangeEndsOnItsOutside) {
  Random random(7);
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const UprightBody& body = i % 2 == 0 ? kColumn : kBox;
    const Vector3d from(random.Uniform(0, 20), random.Uniform(-10, 10), random.Uniform(0, 8));
    const Vector3d way =
        Vector3d(random.Normal(1.0), random.Normal(1.0), random.Normal(0.5)).normalized();
    if (body.Distance(from) <= 0.0) continue;
    const std::optional<double> range = body.Range(from, way);
    const double reach = range.value_or(30.0);
    for (double along = 0.0; along < reach - 1e-6; along += 0.05) {
      ASSERT_GT(body.Distance(from + along * way), 0.0) << i;
    }
    if (!range) continue;
    ++met;
    ASSERT_LT(body.Distance(from + (*range + 1e-9) * way), 1e-6) << i;
  }
  EXPECT_GT(met, 1000);
}

}  // namespace
}  // namespace limpet
