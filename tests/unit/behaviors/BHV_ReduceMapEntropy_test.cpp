// SPDX-License-Identifier: MIT
// Bids of BHV_ReduceMapEntropy on options, against geometry done by hand.
#include "behaviors/BHV_ReduceMapEntropy.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/behaviors/every_behavior.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"

namespace limpet {
namespace {

using BhvReduceMapEntropy = ViewBehaviorTest;

TEST_F(BhvReduceMapEntropy, IsAsManyNatsAsTheImageHasUnseenCells) {
  const BHV_ReduceMapEntropy behavior({});
  const Bid bid = *behavior.Value(Seen(Straight(10.0)), now_);
  const double image = 4.0 * ground_.footprint().half_along(0) * ground_.footprint().half_across(0);
  const double cells = image / (ground_.frame().cell_m * ground_.frame().cell_m);
  EXPECT_NEAR(Reason(bid, "map_entropy"), cells * std::numbers::ln2, 0.06 * cells);
  EXPECT_NEAR(bid.value, std::log(Reason(bid, "map_entropy")), 1e-9);
}

TEST_F(BhvReduceMapEntropy, CountsAViewTwiceThatIsTakenTwice) {
  const BHV_ReduceMapEntropy behavior({});
  Option option = Straight(10.0);
  option.views = {option.path.end()};
  const double once = Reason(*behavior.Value(Seen(option), now_), "map_entropy");
  option.views.push_back(option.path.end());
  EXPECT_NEAR(Reason(*behavior.Value(Seen(option), now_), "map_entropy"), 2.0 * once, 1e-9);
}

TEST_F(BhvReduceMapEntropy, StaysFiniteWhereTheImageShowsNothingOfTheArea) {
  const BHV_ReduceMapEntropy behavior({});
  Option option{.source = "paper", .path = DubinsPath({500.0, 500.0, 0.0}, {{0.0, 1.0}})};
  EXPECT_TRUE(std::isfinite(behavior.Value(Seen(option), now_)->value));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvReduceMapEntropy, EveryBehavior, BHV_ReduceMapEntropy);

}  // namespace
}  // namespace limpet
