// SPDX-License-Identifier: MIT
#include "limpet/core/problem_order.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ProblemOrder, IsByFileThenLineThenKey) {
  const ConfigProblem first{{"a.moos", 2}, "speed", "is missing"};
  const ConfigProblem later_line{{"a.moos", 10}, "depth", "is missing"};
  const ConfigProblem later_key{{"a.moos", 10}, "speed", "is missing"};
  const ConfigProblem later_file{{"b.moos", 1}, "depth", "is missing"};
  EXPECT_LT(OrderOf(first), OrderOf(later_line));
  EXPECT_LT(OrderOf(later_line), OrderOf(later_key));
  EXPECT_LT(OrderOf(later_key), OrderOf(later_file));
}

TEST(ProblemOrder, TellsProblemsOfOneLineApartByTheirText) {
  const ConfigProblem one{{"a.moos", 2}, "speed", "is missing"};
  const ConfigProblem other{{"a.moos", 2}, "speed", "`fast` is not allowed"};
  EXPECT_EQ(OrderOf(one), OrderOf(one));
  EXPECT_NE(OrderOf(one), OrderOf(other));
}

}  // namespace
}  // namespace limpet
