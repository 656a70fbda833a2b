// SPDX-License-Identifier: MIT
#include "limpet/helm/peak_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using enum MotionVariable;

constexpr MotionAxis kDepths{.low = 0.0, .high = 100.0, .points = 21};
constexpr MotionAxis kSpeeds{.low = 0.0, .high = 4.0, .points = 21};

Peak Limit(double deepest, double skirt) {
  return {.summit = 0.5 * deepest,
          .flat_half_width = 0.5 * deepest,
          .base_half_width = 0.5 * deepest + skirt};
}

double SumAt(const std::vector<WeightedPeak>& peaks, double x, MotionVariable variable) {
  double sum = 0.0;
  for (const auto& [peak, weight] : peaks) {
    const double away = x - peak.summit;
    sum += weight * PeakValue(peak, variable == kCourse ? WrapAngle(away) : away);
  }
  return sum;
}

TEST(MaximizeOverPoints, NoOtherPointIsWorthMore) {
  Random random(5, "points");
  for (int run = 0; run < 400; ++run) {
    const MotionVariable variable = kMotionVariables.at(static_cast<std::size_t>(run % 3));
    const bool is_course = variable == kCourse;
    const double low = is_course ? 0.0 : random.Uniform(-2.0, 2.0);
    const MotionAxis axis{.low = low,
                          .high = is_course ? RadiansFromDegrees(350.0) : low + 10.0,
                          .points = is_course ? 36 : 2 + static_cast<int>(random.Index(40))};
    std::vector<WeightedPeak> peaks(1 + random.Index(5));
    for (auto& [peak, weight] : peaks) {
      peak.summit = random.Uniform(axis.low - 1.0, axis.high + 1.0);
      peak.flat_half_width = random.Chance(0.3) ? 0.0 : random.Uniform(0.0, 2.0);
      peak.base_half_width = peak.flat_half_width + random.Uniform(0.01, 4.0);
      peak.edge_value = random.Chance(0.5) ? 1.0 : random.Uniform(0.0, 1.0);
      weight = random.Uniform(0.1, 200.0);
    }
    const double best = SumAt(peaks, MaximizeOverPoints(peaks, axis, variable), variable);
    for (int i = 0; i < axis.points; ++i) {
      ASSERT_GE(best, SumAt(peaks, axis.At(i), variable) - 1e-6) << "run " << run << ", " << i;
    }
  }
}

TEST(MaximizeOverPoints, DoesNotRoundADepthIntoTheSeabed) {
  const std::vector<WeightedPeak> peaks{
      {{.summit = 30.0, .flat_half_width = 3.0, .base_half_width = 103.0, .edge_value = 0.5},
       100.0},
      {Limit(22.6, 0.1), 1000.0}};
  EXPECT_EQ(MaximizeOverPoints(peaks, kDepths, kDepth), 20.0);
}

TEST(MaximizeOverPoints, OfEqualsTheSafestThenTheNearestToWhatIsWantedIsTaken) {
  const WeightedPeak deep{{.summit = 30.0, .flat_half_width = 0.0, .base_half_width = 2.0}, 100.0};
  const WeightedPeak above_20{Limit(20.0, 0.1), 50.0}, above_25{Limit(25.0, 0.1), 50.0};
  EXPECT_EQ(MaximizeOverPoints(std::vector{deep, above_20, above_25}, kDepths, kDepth), 20.0);
  EXPECT_EQ(MaximizeOverInterval(std::vector{deep, above_20, above_25}, {0.0, 100.0}), 20.0);
}

TEST(MaximizeOverPoints, OfASpeedInTheMiddleOfTwoPointsTakesTheSlower) {
  const std::vector<WeightedPeak> peaks{
      {{.summit = 1.3, .flat_half_width = 0.0, .base_half_width = 0.4}, 1.0}};
  EXPECT_NEAR(MaximizeOverPoints(peaks, kSpeeds, kSpeed), 1.2, 1e-9);
}

TEST(StandingAtPoints, APeakThatReachesNoneStandsAtTheNearest) {
  const Peak narrow{.summit = 1.26, .flat_half_width = 0.0, .base_half_width = 0.03};
  EXPECT_NEAR(StandingAtPoints(narrow, kSpeeds, kSpeed).summit, 1.2, 1e-9);
  const Peak too_deep{.summit = 150.0, .flat_half_width = 0.0, .base_half_width = 2.0};
  EXPECT_EQ(StandingAtPoints(too_deep, kDepths, kDepth).summit, 100.0);
  const Peak wide{.summit = 1.26, .flat_half_width = 0.0, .base_half_width = 0.4};
  EXPECT_EQ(StandingAtPoints(wide, kSpeeds, kSpeed).summit, 1.26);
}

}  // namespace
}  // namespace limpet
