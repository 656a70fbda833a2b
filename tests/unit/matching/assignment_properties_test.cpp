// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "estimation/matching/assignment.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kLeftAlone = 5.0;

double TotalOf(const Eigen::MatrixXd& costs, const std::vector<std::optional<int>>& columns) {
  double total = 0.0;
  for (std::size_t row = 0; row < columns.size(); ++row) {
    total += columns[row] ? costs(static_cast<Eigen::Index>(row), *columns[row]) : kLeftAlone;
  }
  return total;
}

/// By trying every column, and none, for each row in turn.
double LeastTotal(const Eigen::MatrixXd& costs, Eigen::Index row, std::set<int>& taken) {
  if (row == costs.rows()) return 0.0;
  double least = kLeftAlone + LeastTotal(costs, row + 1, taken);
  for (int column = 0; column < costs.cols(); ++column) {
    if (taken.contains(column) || costs(row, column) >= kLeftAlone) continue;
    taken.insert(column);
    least = std::min(least, costs(row, column) + LeastTotal(costs, row + 1, taken));
    taken.erase(column);
  }
  return least;
}

Eigen::MatrixXd RandomCosts(Random& random) {
  const auto rows = static_cast<Eigen::Index>(random.Index(6));
  const auto columns = static_cast<Eigen::Index>(random.Index(6));
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&random] {
    return random.Chance(0.2) ? kImpossibleCost : random.Uniform(-3.0, 8.0);
  });
}

TEST(Assignment, IsTheBestThereIsForAnyShapeOfTable) {
  Random random(1, "assignment");
  for (int run = 0; run < 600; ++run) {
    const Eigen::MatrixXd costs = RandomCosts(random);
    const std::vector<std::optional<int>> columns = AssignOneToOne(costs, kLeftAlone);
    ASSERT_EQ(columns.size(), static_cast<std::size_t>(costs.rows()));
    std::set<int> taken;
    EXPECT_NEAR(TotalOf(costs, columns), LeastTotal(costs, 0, taken), 1e-9) << costs;
  }
}

TEST(Assignment, GivesNoColumnTwiceAndNoneThatIsWorseThanNone) {
  Random random(2, "assignment");
  for (int run = 0; run < 600; ++run) {
    const Eigen::MatrixXd costs = RandomCosts(random);
    std::set<int> seen;
    const std::vector<std::optional<int>> columns = AssignOneToOne(costs, kLeftAlone);
    for (std::size_t row = 0; row < columns.size(); ++row) {
      if (!columns[row]) continue;
      EXPECT_TRUE(seen.insert(*columns[row]).second);
      EXPECT_LT(*columns[row], costs.cols());
      EXPECT_LT(costs(static_cast<Eigen::Index>(row), *columns[row]), kLeftAlone);
    }
  }
}

TEST(Assignment, DoesNotCareHowRowsAndColumnsAreNumbered) {
  Random random(3, "assignment");
  for (int run = 0; run < 300; ++run) {
    const Eigen::MatrixXd costs = RandomCosts(random);
    Eigen::PermutationMatrix<Eigen::Dynamic> rows(costs.rows()), columns(costs.cols());
    rows.setIdentity();
    columns.setIdentity();
    std::shuffle(rows.indices().data(), rows.indices().data() + costs.rows(), random.engine());
    std::shuffle(columns.indices().data(), columns.indices().data() + costs.cols(),
                 random.engine());
    const Eigen::MatrixXd mixed = rows * costs * columns;
    EXPECT_NEAR(TotalOf(mixed, AssignOneToOne(mixed, kLeftAlone)),
                TotalOf(costs, AssignOneToOne(costs, kLeftAlone)), 1e-9);
  }
}

TEST(Assignment, OfALargeTableIsFoundAtOnceAndCheaperThanGreed) {
  Random random(4, "assignment");
  const Eigen::MatrixXd costs =
      Eigen::MatrixXd::NullaryExpr(120, 100, [&random] { return random.Uniform(0.0, 10.0); });
  std::set<int> taken;
  std::vector<std::optional<int>> greedy;
  for (Eigen::Index row = 0; row < costs.rows(); ++row) {
    std::optional<int> best;
    for (int column = 0; column < costs.cols(); ++column) {
      const bool is_better = costs(row, column) < (best ? costs(row, *best) : kLeftAlone);
      if (!taken.contains(column) && is_better) best = column;
    }
    if (best) taken.insert(*best);
    greedy.push_back(best);
  }
  EXPECT_LT(TotalOf(costs, AssignOneToOne(costs, kLeftAlone)), TotalOf(costs, greedy) - 1.0);
}

}  // namespace
}  // namespace limpet
