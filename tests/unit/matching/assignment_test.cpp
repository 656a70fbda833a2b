// SPDX-License-Identifier: MIT
#include "estimation/matching/assignment.hpp"

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

TEST(AssignOneToOne, PrefersTheLeastTotalToTheBestSinglePair) {
  Eigen::MatrixXd costs(2, 2);
  costs << 1.0, 2.0, 1.5, 9.0;
  EXPECT_THAT(AssignOneToOne(costs, 10.0), ElementsAre(1, 0));
}

TEST(AssignOneToOne, LeavesARowAloneRatherThanPayTooMuch) {
  Eigen::MatrixXd costs(2, 1);
  costs << 3.0, 20.0;
  EXPECT_THAT(AssignOneToOne(costs, 10.0), ElementsAre(0, std::nullopt));
}

TEST(AssignOneToOne, WorksWithCostsBelowZero) {
  Eigen::MatrixXd costs(2, 3);
  costs << -5.0, 1e6, -4.0, -6.0, 1e6, 1e6;
  EXPECT_THAT(AssignOneToOne(costs, 0.0), ElementsAre(2, 0));
}

TEST(AssignOneToOne, HasNothingToAssignWithoutColumns) {
  EXPECT_THAT(AssignOneToOne(Eigen::MatrixXd(2, 0), 1.0), ElementsAre(std::nullopt, std::nullopt));
}

TEST(AssignOneToOne, BeatsEveryOtherAssignment) {
  constexpr double kAlone = 6.0;
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd costs =
        Eigen::MatrixXd::NullaryExpr(4, 4, [&random] { return random.Uniform(0.0, 10.0); });
    const auto total = [&](const std::vector<std::optional<int>>& columns) {
      double sum = 0.0;
      for (Eigen::Index row = 0; row < costs.rows(); ++row) {
        const std::optional<int> column = columns[static_cast<std::size_t>(row)];
        sum += column ? std::min(costs(row, *column), kAlone) : kAlone;
      }
      return sum;
    };
    const double best = total(AssignOneToOne(costs, kAlone));
    std::vector<std::optional<int>> other{0, 1, 2, 3};
    do {
      EXPECT_LE(best, total(other) + 1e-9);
    } while (std::ranges::next_permutation(other).found);
  }
}

}  // namespace
}  // namespace limpet
