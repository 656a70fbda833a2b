// SPDX-License-Identifier: MIT
// Bids of BHV_ReduceObjectEntropy on options, against geometry done by hand.
#include "behaviors/BHV_ReduceObjectEntropy.hpp"

#include <gtest/gtest.h>

#include "tests/unit/behaviors/every_behavior.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"

namespace limpet {
namespace {

using BhvReduceObjectEntropy = ViewBehaviorTest;

TEST_F(BhvReduceObjectEntropy, CountsObjectsInsideTheImageAlone) {
  BHV_ReduceObjectEntropy::Params params;
  params.lambda = 2.0;
  const BHV_ReduceObjectEntropy behavior(params);
  WatchedObject inside = ObjectAt(10.0, 0.0, {.confirmed = 0.5, .removed = 0.5});
  inside.belief.looks = 1;
  now_.objects = {inside};
  const Bid bid = *behavior.Value(Seen(Straight(10.0)), now_);
  EXPECT_GT(bid.value, 0.0);
  EXPECT_NEAR(bid.value, 2.0 * Reason(bid, "seen"), 1e-12);
  now_.objects[0].belief.object.p_W = {30.0, 0.0, 6.0};
  EXPECT_EQ(behavior.Value(Seen(Straight(10.0)), now_)->value, 0.0);
}

TEST_F(BhvReduceObjectEntropy, InheritedObjectsCountLessTheMoreIsCovered) {
  const BHV_ReduceObjectEntropy behavior({});
  WatchedObject former = ObjectAt(10.0, 0.0, {.confirmed = 0.6, .removed = 0.4});
  former.belief.former_id = 2;
  now_.objects = {former};
  const auto value_at = [&](double covered) {
    now_.coverage.seabed = covered;
    return behavior.Value(Seen(Straight(10.0)), now_)->value;
  };
  const double at_first = value_at(0.0);
  EXPECT_GT(at_first, 0.0);
  EXPECT_NEAR(value_at(0.25), 0.75 * at_first, 1e-9);
  EXPECT_NEAR(value_at(1.0), 0.0, 1e-12);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvReduceObjectEntropy, EveryBehavior, BHV_ReduceObjectEntropy);

}  // namespace
}  // namespace limpet
