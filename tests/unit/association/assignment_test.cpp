// SPDX-License-Identifier: MIT
#include "estimation/association/assignment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  EXPECT_THAT(AssignOneToOne(costs, 10.0), ElementsAre(0, -1));
}

TEST(AssignOneToOne, WorksWithCostsBelowZero) {
  Eigen::MatrixXd costs(2, 3);
  costs << -5.0, 1e6, -4.0, -6.0, 1e6, 1e6;
  EXPECT_THAT(AssignOneToOne(costs, 0.0), ElementsAre(2, 0));
}

TEST(AssignOneToOne, HasNothingToAssignWithoutColumns) {
  EXPECT_THAT(AssignOneToOne(Eigen::MatrixXd(2, 0), 1.0), ElementsAre(-1, -1));
}

}  // namespace
}  // namespace limpet
