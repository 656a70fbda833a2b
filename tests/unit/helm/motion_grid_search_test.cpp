// SPDX-License-Identifier: MIT
// Preferences that join variables: the best point of all, the same one always.
#include "limpet/helm/motion_grid_search.hpp"

#include <algorithm>
#include <array>
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

MotionDomain SmallDomain() {
  return {.course = MotionAxis{.low = 0.0, .high = RadiansFromDegrees(350.0), .points = 36},
          .speed = MotionAxis{.low = 0.0, .high = 2.0, .points = 9},
          .depth = MotionAxis{.low = 0.0, .high = 20.0, .points = 11}};
}

const std::vector<std::vector<MotionVariable>>& Subsets() {
  static const std::vector<std::vector<MotionVariable>> subsets{{kCourse},
                                                                {kSpeed},
                                                                {kDepth},
                                                                {kCourse, kSpeed},
                                                                {kCourse, kDepth},
                                                                {kSpeed, kDepth},
                                                                {kCourse, kSpeed, kDepth}};
  return subsets;
}

/// Preferences at random, and what they are worth at any point, added up with no cleverness.
struct RandomWishes {
  std::vector<MotionTable> tables;
  std::vector<double> weights;
  std::array<std::vector<WeightedPeak>, 3> peaks;

  [[nodiscard]] std::vector<WeightedTable> WeightedTables() const {
    std::vector<WeightedTable> weighted;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      weighted.push_back({&tables[i], weights[i]});
    }
    return weighted;
  }
  [[nodiscard]] bool Joins(MotionVariable variable) const {
    return std::ranges::any_of(tables, [variable](const auto& t) { return t.Covers(variable); });
  }
  /// Worth at the points i of each variable; of variables that no table joins nothing counts.
  [[nodiscard]] double At(const MotionDomain& domain, const std::array<int, 3>& at) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < tables.size(); ++t) {
      std::size_t index = 0;
      for (const MotionVariable variable : kMotionVariables) {
        index += tables[t].stride(variable) * static_cast<std::size_t>(at.at(IndexOf(variable)));
      }
      sum += weights[t] * static_cast<double>(tables[t].values()[index]);
    }
    for (const MotionVariable variable : kMotionVariables) {
      const double x = domain.axis(variable)->At(at.at(IndexOf(variable)));
      for (const auto& [peak, weight] : peaks.at(IndexOf(variable))) {
        const double off = x - peak.summit;
        if (Joins(variable))
          sum += weight * PeakValue(peak, variable == kCourse ? WrapAngle(off) : off);
      }
    }
    return sum;
  }
};

RandomWishes Draw(Random& random, const MotionDomain& domain) {
  RandomWishes wishes;
  const std::size_t count = 1 + random.Index(3);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& over = Subsets()[random.Index(Subsets().size())];
    wishes.tables.emplace_back(domain, over);
    wishes.tables.back().Fill([&random](const MotionPoint&) { return random.Uniform(0.0, 1.0); });
    wishes.weights.push_back(random.Uniform(0.1, 100.0));
  }
  for (const MotionVariable variable : kMotionVariables) {
    const MotionAxis& axis = *domain.axis(variable);
    for (std::size_t i = random.Index(3); i > 0; --i) {
      wishes.peaks.at(IndexOf(variable))
          .push_back({{.summit = random.Uniform(axis.low - 1.0, axis.high + 1.0),
                       .flat_half_width = random.Uniform(0.0, 0.5),
                       .base_half_width = random.Uniform(0.6, 3.0)},
                      random.Uniform(0.1, 100.0)});
    }
  }
  return wishes;
}

TEST(MotionGridSearch, FindsWhatLookingAtEveryPointFinds) {
  const MotionDomain domain = SmallDomain();
  MotionGridSearch search(domain);
  Random random(11, "grid");
  for (int run = 0; run < 150; ++run) {
    const RandomWishes wishes = Draw(random, domain);
    const std::vector<WeightedTable> tables = wishes.WeightedTables();
    const auto chosen = search.Maximise(
        {.tables = tables, .peaks = {wishes.peaks[0], wishes.peaks[1], wishes.peaks[2]}}, {});
    double best = -1.0;
    std::array<int, 3> best_at{};
    std::array<int, 3> at{};
    for (at[0] = 0; at[0] < (wishes.Joins(kCourse) ? 36 : 1); ++at[0]) {
      for (at[1] = 0; at[1] < (wishes.Joins(kSpeed) ? 9 : 1); ++at[1]) {
        for (at[2] = 0; at[2] < (wishes.Joins(kDepth) ? 11 : 1); ++at[2]) {
          if (const double value = wishes.At(domain, at); value > best) {
            best = value;
            best_at = at;
          }
        }
      }
    }
    for (const MotionVariable variable : kMotionVariables) {
      const auto& value = chosen.at(IndexOf(variable));
      ASSERT_EQ(value.has_value(), wishes.Joins(variable));
      if (!value) continue;
      const double expected = domain.axis(variable)->At(best_at.at(IndexOf(variable)));
      EXPECT_NEAR(*value, variable == kCourse ? WrapAngle(expected) : expected, 1e-12)
          << NameOf(variable) << " in run " << run;
    }
  }
}

TEST(MotionGridSearch, TakesTheNearestOfPointsThatAreAsGood) {
  const MotionDomain domain = SmallDomain();
  MotionGridSearch search(domain);
  MotionTable all_alike(domain, {kCourse, kSpeed, kDepth});
  all_alike.Fill([](const MotionPoint&) { return 0.5; });
  const std::vector<WeightedTable> tables{{&all_alike, 3.0}};
  const auto chosen =
      search.Maximise({.tables = tables, .peaks = {}}, {RadiansFromDegrees(-12.0), 1.3, 7.1});
  EXPECT_NEAR(MoosHeadingFromYaw(*chosen[0]), 350.0, 1e-9) << "across north";
  EXPECT_DOUBLE_EQ(*chosen[1], 1.25);
  EXPECT_DOUBLE_EQ(*chosen[2], 8.0);
}

TEST(MotionGridSearch, TakesTheFirstOfTwoThatAreAsNear) {
  const MotionDomain domain = SmallDomain();
  MotionGridSearch search(domain);
  MotionTable past_it(domain, {kCourse});
  past_it.Fill([](const MotionPoint& point) {  // 30 deg to either side of an obstacle ahead
    return std::abs(WrapAngle(point.course - RadiansFromDegrees(90.0))) > 0.5 ? 1.0 : 0.0;
  });
  const std::vector<WeightedTable> tables{{&past_it, 1.0}};
  for (int time = 0; time < 3; ++time) {
    const auto chosen =
        search.Maximise({.tables = tables, .peaks = {}}, {RadiansFromDegrees(90.0), 0.0, 0.0});
    EXPECT_NEAR(MoosHeadingFromYaw(*chosen[0]), 60.0, 1e-9) << "to port, and the same every time";
  }
}

TEST(MotionGridSearch, WeighsAPeakAcrossNorthAgainstATable) {
  const MotionDomain domain = SmallDomain();
  MotionGridSearch search(domain);
  MotionTable not_north(domain, {kCourse, kSpeed});
  not_north.Fill([](const MotionPoint& point) {
    return std::abs(point.course) < RadiansFromDegrees(15.0) && point.speed > 0.5 ? 0.0 : 1.0;
  });
  const std::vector<WeightedTable> tables{{&not_north, 100.0}};
  const std::vector<WeightedPeak> course{
      {{.summit = RadiansFromDegrees(356.0), .flat_half_width = 0.0, .base_half_width = 1.0}, 1.0}};
  const std::vector<WeightedPeak> speed{
      {{.summit = 1.5, .flat_half_width = 0.0, .base_half_width = 1.5}, 1.0}};
  const auto chosen =
      search.Maximise({.tables = tables, .peaks = {course, speed, {}}}, {0.0, 1.5, 0.0});
  EXPECT_NEAR(MoosHeadingFromYaw(*chosen[0]), 340.0, 1e-9) << "the near side, at full speed";
  EXPECT_DOUBLE_EQ(*chosen[1], 1.5);
  EXPECT_FALSE(chosen[2].has_value());
}

TEST(MotionTable, LeavesOutWhatTheDomainLacks) {
  MotionDomain surface = SmallDomain();
  surface.depth.reset();
  MotionTable table(surface, {kSpeed, kDepth});
  EXPECT_TRUE(table.Covers(kSpeed));
  EXPECT_FALSE(table.Covers(kDepth));
  EXPECT_FALSE(table.Covers(kCourse));
  table.Fill([](const MotionPoint& point) { return 0.5 * point.speed + point.depth; });
  EXPECT_EQ(table.values().size(), 9U);
  EXPECT_EQ(table.values()[8], 1.0F);
}

TEST(MotionTable, SaysWhichOfItsNumbersIsNone) {
  MotionTable table(SmallDomain(), {kCourse, kSpeed});
  table.Fill([](const MotionPoint& point) { return point.speed > 1.9 ? std::nan("") : 0.0; });
  EXPECT_EQ(*table.Problem(), "NaN in its function at course 0.0 deg, speed 2 m/s, depth 0 m");
  table.Fill([](const MotionPoint& point) { return point.speed; });
  EXPECT_EQ(
      *table.Problem(),
      "1.25, outside of 0 to 1, in its function at course 0.0 deg, speed 1.25 m/s, depth 0 m");
  table.Fill([](const MotionPoint&) { return 1.0; });
  EXPECT_FALSE(table.Problem().has_value());
}

}  // namespace
}  // namespace limpet
