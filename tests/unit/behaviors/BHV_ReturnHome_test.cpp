// SPDX-License-Identifier: MIT
// Bids of BHV_ReturnHome on options, against geometry done by hand.
#include "behaviors/BHV_ReturnHome.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using BhvReturnHome = ViewBehaviorTest;

TEST_F(BhvReturnHome, ChargesAWholeForTheWayFromItsEnd) {
  Option& whole = Straight(100.0);
  whole.own_m = 25.0;
  now_.home = {.north = 100.0, .east = 30.0};
  const BHV_ReturnHome in_time({.when = "late"});
  EXPECT_NEAR(in_time.Value(Seen(whole), now_)->value, -30.0, 1e-9);
}

TEST_F(BhvReturnHome, LooksAtAWholesOwnPartForTheRange) {
  Option& whole = Straight(1000.0);
  now_.home = {.north = 0.0, .east = 0.0};
  BHV_ReturnHome::Params params;
  params.when = "late", params.range = Meters(60.0);
  whole.own_m = 25.0;
  EXPECT_EQ(Reason(*BHV_ReturnHome(params).Value(Seen(whole), now_), "overrun"), 0.0);
  whole.own_m = 35.0;
  EXPECT_NEAR(Reason(*BHV_ReturnHome(params).Value(Seen(whole), now_), "overrun"), 10.0, 1e-9);
}

TEST_F(BhvReturnHome, CountsTheWayAlongTheOptionAndOnToHome) {
  now_.home = {.north = 6.0, .east = 8.0};
  const BHV_ReturnHome behavior({});
  const Bid bid = *behavior.Value(Seen(Straight(6.0)), now_);
  EXPECT_NEAR(bid.value, -(6.0 + 8.0), 1e-9);
  EXPECT_NEAR(Reason(bid, "to_go"), 14.0, 1e-9);
}

TEST_F(BhvReturnHome, LikesWhatEndsNearerHomeForTheSameWay) {
  Random random(2, "home");
  const BHV_ReturnHome behavior({});
  for (int run = 0; run < 300; ++run) {
    now_.home = {.north = random.Uniform(-30.0, 30.0), .east = random.Uniform(-30.0, 30.0)};
    const double bearing = std::atan2(now_.home.east, now_.home.north);
    const double towards = behavior.Value(Seen(Straight(5.0, bearing)), now_)->value;
    const double aside =
        behavior.Value(Seen(Straight(5.0, bearing + random.Uniform(0.2, std::numbers::pi))), now_)
            ->value;
    EXPECT_GT(towards, aside);
  }
}

TEST_F(BhvReturnHome, LateCostsNothingUntilTheRangeRunsOut) {
  BHV_ReturnHome::Params params;
  params.when = "late";
  params.range = Meters(100.0);
  params.lateness_weight = 5.0;
  const BHV_ReturnHome behavior(params);
  now_.home = {.north = 20.0, .east = 0.0};
  const auto value_after = [&](double travelled) {
    now_.travelled = travelled;
    return behavior.Value(Seen(Straight(10.0)), now_)->value;  // 10 m along, 10 m on to home
  };
  EXPECT_EQ(value_after(0.0), 0.0);
  EXPECT_EQ(value_after(80.0), 0.0);
  EXPECT_NEAR(value_after(83.0), -5.0 * 3.0, 1e-9);
  EXPECT_FALSE(behavior.WantsView()) << "it only charges; it does not ask for a way";
  EXPECT_TRUE(BHV_ReturnHome({}).WantsView());
}

TEST_F(BhvReturnHome, LateRefusesWhatTheBatteryDoesNotReachHomeAfter) {
  BHV_ReturnHome::Params params;
  params.when = "late";
  const BHV_ReturnHome behavior(params);
  now_.home = {.north = 20.0, .east = 0.0};
  const auto is_refused = [&](double reach) {
    now_.reach = Meters(reach);
    return behavior.Value(Seen(Straight(10.0)), now_)->veto.has_value();
  };
  EXPECT_FALSE(is_refused(21.0)) << "10 m along, 10 m on to home";
  EXPECT_TRUE(is_refused(19.0));
  Straight(20.0).source = "home";
  EXPECT_FALSE(behavior.Value(Seen(option_), now_)->veto) << "nothing is nearer than the way home";
  SearchGoals goals;
  behavior.Shape(now_, 1.0, goals);
  EXPECT_EQ(goals.destinations.size(), 1U) << "where all else is refused the way home is offered";
}

TEST_F(BhvReturnHome, LateAsksForAWayHomeInTime) {
  BHV_ReturnHome::Params params;
  params.when = "late";
  params.range = Meters(100.0);
  const BHV_ReturnHome behavior(params);
  now_.home = {.north = 30.0, .east = 0.0};
  const auto destinations = [&](double travelled) {
    now_.travelled = travelled;
    SearchGoals goals;
    behavior.Shape(now_, 1.0, goals);
    return goals.destinations;
  };
  EXPECT_THAT(destinations(10.0), IsEmpty());
  // The way home is 30 m at least: whoever has flown 70 m and has not been offered it is late.
  EXPECT_THAT(destinations(70.0), SizeIs(1));
  EXPECT_EQ(destinations(70.0)[0].north, 30.0);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvReturnHome, EveryBehavior, BHV_ReturnHome);

}  // namespace
}  // namespace limpet
