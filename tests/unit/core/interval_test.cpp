// SPDX-License-Identifier: MIT
#include "limpet/core/interval.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Interval DrawInterval(Random& random) {
  const double low = random.Uniform(-10.0, 10.0);
  return {.low = low, .high = low + random.Uniform(0.0, 8.0)};
}

TEST(Interval, TheNearestPointIsInItAndNoneIsNearer) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Interval interval = DrawInterval(random);
    const double at = random.Uniform(-20.0, 20.0), nearest = interval.Nearest(at);
    EXPECT_GE(nearest, interval.low);
    EXPECT_LE(nearest, interval.high);
    const double other = random.Uniform(interval.low, interval.high + 1e-12);
    EXPECT_LE(std::abs(nearest - at), std::abs(other - at) + 1e-12);
    EXPECT_EQ(interval.Nearest(nearest), nearest);
  }
}

TEST(Interval, DrawnInIsShorterAtBothEndsOrItsMiddle) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Interval interval = DrawInterval(random);
    const double inset = random.Uniform(0.0, 6.0);
    const Interval inner = interval.DrawnIn(inset);
    EXPECT_FALSE(inner.is_empty());
    EXPECT_NEAR(inner.middle(), interval.middle(), 1e-12);
    EXPECT_NEAR(inner.high - inner.low, std::max(0.0, interval.high - interval.low - 2.0 * inset),
                1e-12);
  }
}

TEST(Interval, ACutHoldsWhatBothHold) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Interval a = DrawInterval(random), b = DrawInterval(random);
    Interval both = a, other = b;
    both.Cut(b), other.Cut(a);
    EXPECT_EQ(both.low, other.low);
    EXPECT_EQ(both.high, other.high);
    const double at = random.Uniform(-12.0, 20.0);
    const auto holds = [at](const Interval& x) { return at >= x.low && at <= x.high; };
    EXPECT_EQ(holds(both), holds(a) && holds(b));
  }
}

}  // namespace
}  // namespace limpet
