// SPDX-License-Identifier: MIT
#include "limpet/helm/peak.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

double SumOnInterval(std::span<const WeightedPeak> peaks, double x) {
  double sum = 0.0;
  for (const WeightedPeak& p : peaks) {
    sum += p.weight * PeakValue(p.peak, x - p.peak.summit);
  }
  return sum;
}

TEST(Peak, IsOneOnTheFlatTopAndZeroBeyondTheBase) {
  const Peak peak{.summit = 3.0, .flat_half_width = 0.5, .base_half_width = 2.5};
  EXPECT_DOUBLE_EQ(PeakValue(peak, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(PeakValue(peak, -1.5), 0.5);
  EXPECT_DOUBLE_EQ(PeakValue(peak, 2.6), 0.0);
}

TEST(MotionArbitration, FollowsTheOnlyBidder) {
  const std::array peaks{
      WeightedPeak{{.summit = 3.5, .flat_half_width = 0.0, .base_half_width = 5.0}, 1.0}};
  EXPECT_DOUBLE_EQ(MaximizeOverInterval(peaks, {0.0, 10.0}), 3.5);
}

TEST(MotionArbitration, StaysInsideTheDomain) {
  const std::array peaks{
      WeightedPeak{{.summit = -4.0, .flat_half_width = 0.0, .base_half_width = 9.0}, 1.0}};
  EXPECT_DOUBLE_EQ(MaximizeOverInterval(peaks, {0.0, 10.0}), 0.0);
}

TEST(MotionArbitration, GivesWayToTheHeavierOfTwoThatExcludeEachOther) {
  const std::array peaks{
      WeightedPeak{{.summit = 1.0, .flat_half_width = 0.0, .base_half_width = 0.5}, 1.0},
      WeightedPeak{{.summit = 8.0, .flat_half_width = 0.0, .base_half_width = 0.5}, 2.0}};
  EXPECT_DOUBLE_EQ(MaximizeOverInterval(peaks, {0.0, 10.0}), 8.0);
}

TEST(MotionArbitration, GoesAsFarAsItMayForWhoWantsMore) {
  const WeightedPeak at_most_7{{.summit = 3.5, .flat_half_width = 3.5, .base_half_width = 4.5},
                               2.0};
  const WeightedPeak deep{{.summit = 50.0, .flat_half_width = 8.0, .base_half_width = 20.0}, 1.0};
  EXPECT_EQ(MaximizeOverInterval(std::vector{at_most_7, deep}, {0.0, 199.0}), 7.0);
  EXPECT_EQ(MaximizeOverInterval(std::vector{at_most_7}, {0.0, 199.0}), 3.5);
}

TEST(MotionArbitration, NeverDoesWorseThanAFineGrid) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<WeightedPeak> peaks;
    for (int i = 0; i < 4; ++i) {
      const double flat = random.Uniform(0.0, 1.0);
      peaks.push_back({{.summit = random.Uniform(-2.0, 12.0),
                        .flat_half_width = flat,
                        .base_half_width = flat + random.Uniform(0.1, 4.0)},
                       random.Uniform(0.1, 3.0)});
    }
    const double best = SumOnInterval(peaks, MaximizeOverInterval(peaks, {0.0, 10.0}));
    for (double x = 0.0; x <= 10.0; x += 0.01) {
      ASSERT_GE(best, SumOnInterval(peaks, x) - 1e-9);
    }
  }
}

TEST(MotionArbitration, TakesTheShortWayAcrossNorth) {
  const std::array peaks{
      WeightedPeak{
          {.summit = std::numbers::pi - 0.1, .flat_half_width = 0.0, .base_half_width = 1.0}, 1.0},
      WeightedPeak{
          {.summit = -std::numbers::pi + 0.1, .flat_half_width = 0.0, .base_half_width = 1.0},
          1.0}};
  EXPECT_GT(std::abs(MaximizeOverCircle(peaks)), std::numbers::pi - 0.11);
}

TEST(PeakValue, FallsFromTheSummitToTheEdgeOfATopThatIsNotFlat) {
  const Peak peak{
      .summit = 0.0, .flat_half_width = 3.0, .base_half_width = 103.0, .edge_value = 0.5};
  EXPECT_DOUBLE_EQ(PeakValue(peak, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(PeakValue(peak, -1.5), 0.75);
  EXPECT_DOUBLE_EQ(PeakValue(peak, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(PeakValue(peak, 53.0), 0.25);
  EXPECT_DOUBLE_EQ(PeakValue(peak, 200.0), 0.0);
}

}  // namespace
}  // namespace limpet
