// SPDX-License-Identifier: MIT
// "How now" is decided exactly: over random preferences, against a fine search.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "limpet/helm/peak.hpp"

namespace limpet {
namespace {

class PeakProperties : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] std::vector<WeightedPeak> DrawPeaks(double low, double high) {
    std::vector<WeightedPeak> peaks(1 + random_.Index(6));
    for (auto& [peak, weight] : peaks) {
      peak.summit = random_.Uniform(low, high);
      peak.flat_half_width = random_.Chance(0.3) ? 0.0 : random_.Uniform(0.0, 0.2 * (high - low));
      peak.base_half_width = peak.flat_half_width + random_.Uniform(0.01, 0.5) * (high - low);
      weight = random_.Uniform(0.1, 100.0);
    }
    return peaks;
  }
  [[nodiscard]] static double SumOnLine(const std::vector<WeightedPeak>& peaks, double x) {
    double sum = 0.0;
    for (const auto& [peak, weight] : peaks)
      sum += weight * PeakValue(peak, x - peak.summit);
    return sum;
  }
  [[nodiscard]] static double SumOnCircle(const std::vector<WeightedPeak>& peaks, double x) {
    double sum = 0.0;
    for (const auto& [peak, weight] : peaks)
      sum += weight * PeakValue(peak, WrapAngle(x - peak.summit));
    return sum;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "peaks"};
};

TEST_P(PeakProperties, AValueIsAShareThatFallsFromTheSummit) {
  for (const auto& [peak, weight] : DrawPeaks(-5.0, 5.0)) {
    double before = 1.0;
    for (double off = 0.0; off < 8.0; off += 0.05) {
      const double value = PeakValue(peak, off);
      EXPECT_LE(value, before);
      EXPECT_GE(value, 0.0);
      EXPECT_EQ(value, PeakValue(peak, -off)) << "the same to both sides";
      before = value;
    }
    EXPECT_EQ(PeakValue(peak, peak.flat_half_width), 1.0);
    EXPECT_NEAR(PeakValue(peak, peak.base_half_width), 0.0, 1e-9);
    EXPECT_NEAR(PeakValue(peak, 0.5 * (peak.flat_half_width + peak.base_half_width)), 0.5, 1e-9);
  }
}

TEST_P(PeakProperties, NoValueInTheIntervalIsWorthMore) {
  for (int run = 0; run < 20; ++run) {
    const double low = random_.Uniform(-10.0, 0.0), high = low + random_.Uniform(0.5, 15.0);
    const std::vector<WeightedPeak> peaks = DrawPeaks(low - 3.0, high + 3.0);
    const double best = MaximizeOverInterval(peaks, {low, high});
    EXPECT_GE(best, low);
    EXPECT_LE(best, high);
    for (int i = 0; i <= 400; ++i)
      EXPECT_LE(SumOnLine(peaks, low + (high - low) * i / 400.0), SumOnLine(peaks, best) + 1e-6);
  }
}

TEST_P(PeakProperties, NoCourseIsWorthMore) {
  for (int run = 0; run < 20; ++run) {
    const std::vector<WeightedPeak> peaks = DrawPeaks(-std::numbers::pi, std::numbers::pi);
    const double best = MaximizeOverCircle(peaks);
    EXPECT_GT(best, -std::numbers::pi);
    EXPECT_LE(best, std::numbers::pi);
    for (int i = 0; i < 720; ++i) {
      EXPECT_LE(SumOnCircle(peaks, 2.0 * std::numbers::pi * i / 720.0),
                SumOnCircle(peaks, best) + 1e-6);
    }
  }
}

TEST_P(PeakProperties, ACourseTurnsWithItsPreferences) {
  for (int run = 0; run < 20; ++run) {
    std::vector<WeightedPeak> peaks = DrawPeaks(-std::numbers::pi, std::numbers::pi);
    const double before = MaximizeOverCircle(peaks), turn = random_.Uniform(-3.0, 3.0);
    std::vector<WeightedPeak> turned = peaks;
    for (auto& [peak, weight] : turned)
      peak.summit = WrapAngle(peak.summit + turn);
    EXPECT_NEAR(SumOnCircle(turned, MaximizeOverCircle(turned)), SumOnCircle(peaks, before), 1e-6);
  }
}

TEST_P(PeakProperties, WeightsCountByTheirRatiosAlone) {
  for (int run = 0; run < 20; ++run) {
    std::vector<WeightedPeak> peaks = DrawPeaks(0.0, 10.0);
    const double before = MaximizeOverInterval(peaks, {0.0, 10.0});
    for (auto& [peak, weight] : peaks)
      weight *= 4.0;
    EXPECT_NEAR(MaximizeOverInterval(peaks, {0.0, 10.0}), before, 1e-9);
  }
}

TEST_P(PeakProperties, TheOrderOfPreferencesDoesNotMatterUnlessTheyAreEqual) {
  for (int run = 0; run < 20; ++run) {
    std::vector<WeightedPeak> peaks = DrawPeaks(0.0, 10.0);
    const double before = MaximizeOverInterval(peaks, {0.0, 10.0});
    std::ranges::reverse(peaks);
    EXPECT_NEAR(SumOnLine(peaks, MaximizeOverInterval(peaks, {0.0, 10.0})),
                SumOnLine(peaks, before), 1e-6);
  }
}

TEST_P(PeakProperties, AmongEqualsTheHeaviestsSummitIsTaken) {
  // Flat tops that overlap: every value of the overlap is worth the same.
  const double heavy = random_.Uniform(4.0, 5.0), light = heavy + random_.Uniform(0.1, 0.9);
  const std::vector<WeightedPeak> peaks{
      {{.summit = light, .flat_half_width = 1.0, .base_half_width = 2.0}, 1.0},
      {{.summit = heavy, .flat_half_width = 1.0, .base_half_width = 2.0}, 2.0}};
  EXPECT_EQ(MaximizeOverInterval(peaks, {0.0, 10.0}), heavy);
  EXPECT_EQ(MaximizeOverCircle(peaks), WrapAngle(heavy));
}

INSTANTIATE_TEST_SUITE_P(Drawn, PeakProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
