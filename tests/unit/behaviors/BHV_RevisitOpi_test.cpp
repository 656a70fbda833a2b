// SPDX-License-Identifier: MIT
// Bids of BHV_RevisitOpi on options, against geometry done by hand.
#include "behaviors/BHV_RevisitOpi.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/behaviors/every_behavior.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"

namespace limpet {
namespace {

using BhvRevisitOpi = ViewBehaviorTest;

TEST_F(BhvRevisitOpi, IsWorthLessTheLaterTheLook) {
  now_.objects = {ObjectAt(10.0, 0.0, {.confirmed = 0.5, .removed = 0.5})};
  BHV_RevisitOpi::Params params;
  params.decay = Meters(50.0);
  const BHV_RevisitOpi behavior(params);
  const Bid bid = *behavior.Value(Seen(Straight(20.0)), now_);
  // The object enters the window of 1 m when the vehicle has come 9 m.
  const double now_worth = behavior.Interests(now_).at(0).worth;
  EXPECT_GT(now_worth, 0.0);
  EXPECT_NEAR(bid.value, now_worth * (1.0 - 9.0 / 50.0), 1e-9);
  EXPECT_EQ(Reason(bid, "open_objects"), 1.0);
}

TEST_F(BhvRevisitOpi, GivesNothingForAWayThatMissesTheObject) {
  now_.objects = {ObjectAt(10.0, 1.5, {.confirmed = 0.5, .removed = 0.5})};
  const BHV_RevisitOpi behavior({});
  EXPECT_EQ(behavior.Value(Seen(Straight(20.0)), now_)->value, 0.0);
  EXPECT_EQ(behavior.Value(Seen(Straight(8.0)), now_)->value, 0.0);
}

TEST_F(BhvRevisitOpi, HasNoOpinionOnceAllIsKnown) {
  now_.objects = {ObjectAt(10.0, 0.0, {.confirmed = 0.999, .removed = 0.001})};
  const BHV_RevisitOpi behavior({});
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_));
  now_.objects = {ObjectAt(10.0, 0.0, {.confirmed = 0.5, .removed = 0.5})};
  EXPECT_TRUE(behavior.Value(Seen(Straight(20.0)), now_));
  now_.objects[0].belief.looks = RevisitPolicy::Params{}.settled_looks;
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_)) << "looked at often enough";
  now_.objects[0].belief.looks = 0;
  now_.objects[0].window.reset();
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_)) << "not seen from survey altitude";
}

TEST_F(BhvRevisitOpi, IsWorthTheSumOfItsObjectsWhateverTheirOrder) {
  const BHV_RevisitOpi behavior({});
  const std::vector<WatchedObject> objects{ObjectAt(5.0, 0.0, {.confirmed = 0.5, .removed = 0.5}),
                                           ObjectAt(12.0, 0.5, {.confirmed = 0.8, .removed = 0.2}),
                                           ObjectAt(18.0, -0.5, {.appeared = 0.6, .nothing = 0.4})};
  double sum = 0.0;
  for (const WatchedObject& object : objects) {
    now_.objects = {object};
    sum += behavior.Value(Seen(Straight(20.0)), now_)->value;
  }
  now_.objects = {objects[2], objects[0], objects[1]};
  EXPECT_NEAR(behavior.Value(Seen(Straight(20.0)), now_)->value, sum, 1e-9);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvRevisitOpi, EveryBehavior, BHV_RevisitOpi);

}  // namespace
}  // namespace limpet
