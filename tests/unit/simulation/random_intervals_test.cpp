// SPDX-License-Identifier: MIT
#include "limpet/simulation/random_intervals.hpp"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

namespace limpet {
namespace {

struct Seen {
  int count = 0;
  double inside_s = 0.0;
  double shortest = 1e9, longest = 0.0;
};

/// Of two hours, asked every `step` seconds.
Seen Watch(const RandomIntervals::Params& params, double step, std::uint64_t seed) {
  Random random(seed);
  RandomIntervals intervals(params);
  Seen seen;
  double since = -1.0;
  for (double t = 0.0; t < 7200.0; t += step) {
    if (intervals.Contain(Seconds(t), random)) {
      seen.inside_s += step;
      since = since < 0.0 ? t : since;
    } else if (since >= 0.0) {
      seen.shortest = std::min(seen.shortest, t - since);
      seen.longest = std::max(seen.longest, t - since);
      since = -1.0;
    }
  }
  seen.count = intervals.count();
  return seen;
}

TEST(RandomIntervals, AreNoneWithoutARate) {
  const Seen seen =
      Watch({.per_second = 0.0, .shortest = Seconds(5.0), .longest = Seconds(9.0)}, 1.0, 1);
  EXPECT_EQ(seen.count, 0);
  EXPECT_EQ(seen.inside_s, 0.0);
}

TEST(RandomIntervals, ComeAtTheirRateAndLastAsTheySay) {
  const RandomIntervals::Params params{
      .per_second = 0.02, .shortest = Seconds(4.0), .longest = Seconds(8.0)};
  double count = 0.0, inside = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Seen seen = Watch(params, 0.25, seed);
    EXPECT_GE(seen.shortest, 4.0 - 0.26);
    // Two may follow each other within a step.
    EXPECT_LE(seen.longest, 2.0 * 8.0 + 0.26);
    count += seen.count, inside += seen.inside_s;
  }
  // One takes 6 s and 50 s of waiting on average.
  EXPECT_NEAR(count / 10.0, 7200.0 / 56.0, 12.0);
  EXPECT_NEAR(inside / count, 6.0, 0.3);
}

TEST(RandomIntervals, AreTheSameForTheSameSeed) {
  const RandomIntervals::Params params{
      .per_second = 0.05, .shortest = Seconds(1.0), .longest = Seconds(3.0)};
  EXPECT_EQ(Watch(params, 0.5, 3).inside_s, Watch(params, 0.5, 3).inside_s);
  EXPECT_NE(Watch(params, 0.5, 3).inside_s, Watch(params, 0.5, 4).inside_s);
}

TEST(RandomIntervals, PassedOverByALongStepAreStillCounted) {
  const RandomIntervals::Params params{
      .per_second = 0.5, .shortest = Seconds(0.1), .longest = Seconds(0.2)};
  EXPECT_GT(Watch(params, 60.0, 5).count, 2000);
}

}  // namespace
}  // namespace limpet
