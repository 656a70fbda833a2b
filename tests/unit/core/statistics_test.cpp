// SPDX-License-Identifier: MIT
#include "limpet/core/statistics.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

std::vector<double> Drawn(Random& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values)
    value = random.Uniform(-5.0, 5.0);
  return values;
}

TEST(UpperMedian, IsTheMiddleValueOfTwoTheGreater) {
  EXPECT_EQ(UpperMedian(std::vector{3.0}), 3.0);
  EXPECT_EQ(UpperMedian(std::vector{3.0, 1.0}), 3.0);
  EXPECT_EQ(UpperMedian(std::vector{9.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(UpperMedian(std::vector{4.0F, 3.0F, 1.0F, 2.0F}), 3.0F);
}

TEST(UpperMedian, HasAsManyBelowAsAbove) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> values = Drawn(random, 1 + random.Index(40));
    const double median = UpperMedian(values);
    std::ranges::sort(values);
    EXPECT_EQ(values[values.size() / 2], median);
  }
}

TEST(Quantile, IsOneOfTheValuesAndZeroOfNone) {
  const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
  EXPECT_EQ(Quantile(values, 0.0), 1.0);
  EXPECT_EQ(Quantile(values, 0.5), 2.0) << "of two middle ones the lesser";
  EXPECT_EQ(Quantile(values, 0.99), 3.0);
  EXPECT_EQ(Quantile(values, 1.0), 4.0);
  EXPECT_EQ(Quantile({}, 0.5), 0.0);
}

TEST(Quantile, HasItsShareOfTheOthersBelow) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> values = Drawn(random, 1 + random.Index(40));
    const double share = random.Uniform(0.0, 1.0), quantile = Quantile(values, share);
    const auto others = static_cast<double>(values.size() - 1);
    const auto below = static_cast<double>(
        std::ranges::count_if(values, [quantile](double value) { return value < quantile; }));
    EXPECT_LE(below, share * others);
    EXPECT_GT(below + 1.0, share * others);
  }
}

TEST(Quantile, OfSortedValuesIsTheSame) {
  Random random(3);
  const std::vector<double> values = Drawn(random, 57);
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  for (const double share : {0.0, 0.16, 0.5, 0.8, 0.95, 0.99, 1.0})
    EXPECT_EQ(QuantileOfSorted(sorted, share), Quantile(values, share)) << share;
}

}  // namespace
}  // namespace limpet
