// SPDX-License-Identifier: MIT
// What each behavior bids on an option, against geometry done by hand.
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "behaviors/BHV_CoverArea.hpp"
#include "behaviors/BHV_OpRegion.hpp"
#include "behaviors/BHV_ReduceMapEntropy.hpp"
#include "behaviors/BHV_ReduceObjectEntropy.hpp"
#include "behaviors/BHV_ReturnHome.hpp"
#include "behaviors/BHV_RevisitOpi.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kPi = std::numbers::pi;

/// A vehicle at the origin that heads north, over ground of which nothing has been seen.
class ViewBehaviorTest : public ::testing::Test {
 protected:
  ViewBehaviorTest() {
    now_.ground = &ground_;
    now_.region = &region_;
  }
  Option& Straight(double length, double yaw = 0.0) {
    option_ = {.source = "beam", .path = DubinsPath({0.0, 0.0, yaw}, {{0.0, length}})};
    return option_;
  }
  [[nodiscard]] Prospect Seen(const Option& option, double area = 0.0, double border = 0.0) const {
    return {option, {.new_area = area, .frontier_growth = border}};
  }
  static double Reason(const Bid& bid, const std::string& name) {
    for (const auto& reason : bid.why) {
      if (reason.name == name) return reason.value;
    }
    ADD_FAILURE() << "no reason `" << name << "`";
    return 0.0;
  }
  static WatchedObject ObjectAt(double north, double east, const StatusPosterior& posterior) {
    WatchedObject object;
    object.belief.id = 4;
    object.belief.object.p_W = {north, east, 6.0};
    object.belief.posterior = posterior;
    object.window = LookWindow{.half_along = 1.0, .half_across = 1.0};
    return object;
  }

  SurveyArea area_{-40.0, 40.0, -40.0, 40.0, 2.0, 2.0};
  SurveyGrid grid_{area_};
  Ground ground_{grid_, Footprint(4.0, 2.0, CameraModel{})};
  Region region_{area_};
  Situation now_;
  Option option_;
};

TEST_F(ViewBehaviorTest, CoverAreaPrefersTheWholeThatShowsGroundSooner) {
  Option& whole = Straight(100.0);
  whole.own_m = 25.0;
  const BHV_CoverArea cover({.rates = {.cover = 1.0, .frontier = 0.0, .early = 1.0}});
  const double area = ground_.wanted_m2();
  const Prospect soon(whole, {.new_area = 50.0, .delay = 10.0 * area});
  const Prospect late(whole, {.new_area = 50.0, .delay = 30.0 * area});
  EXPECT_NEAR(cover.Value(soon, now_)->value - cover.Value(late, now_)->value, 20.0, 1e-9);
  EXPECT_NEAR(Reason(*cover.Value(late, now_), "length"), 100.0, 1e-9);
}

TEST_F(ViewBehaviorTest, CoverAreaDoesNotAskWhenAnOptionThatIsNoWholeShowsIt) {
  const BHV_CoverArea cover({.rates = {.cover = 1.0, .frontier = 0.0, .early = 1.0}});
  const Prospect part(Straight(20.0), {.new_area = 50.0, .delay = 500.0});
  EXPECT_EQ(cover.Value(part, now_)->why.size(), 3U);
}

TEST_F(ViewBehaviorTest, CoverAreaChargesForTheCurrentAndSaysSo) {
  const BHV_CoverArea cover({});
  const double still = cover.Value(Seen(Straight(40.0)), now_)->value;
  now_.course_cost.metres = {1.5, 1.1, 0.7, 1.1};
  const Bid against = *cover.Value(Seen(Straight(40.0)), now_);
  EXPECT_NEAR(still - against.value, 20.0, 1e-9);
  EXPECT_NEAR(Reason(against, "current"), 20.0, 1e-9);
  EXPECT_NEAR(cover.Value(Seen(Straight(40.0, kPi)), now_)->value - still, 12.0, 1e-9);
}

TEST_F(ViewBehaviorTest, ReturnHomeChargesAWholeForTheWayFromItsEnd) {
  Option& whole = Straight(100.0);
  whole.own_m = 25.0;
  now_.home = {.north = 100.0, .east = 30.0};
  const BHV_ReturnHome in_time({.when = "late"});
  EXPECT_NEAR(in_time.Value(Seen(whole), now_)->value, -30.0, 1e-9);
}

TEST_F(ViewBehaviorTest, ReturnHomeLooksAtAWholesOwnPartForTheRange) {
  Option& whole = Straight(1000.0);
  now_.home = {.north = 0.0, .east = 0.0};
  BHV_ReturnHome::Params params;
  params.when = "late", params.range = Meters(60.0);
  whole.own_m = 25.0;
  EXPECT_EQ(Reason(*BHV_ReturnHome(params).Value(Seen(whole), now_), "overrun"), 0.0);
  whole.own_m = 35.0;
  EXPECT_NEAR(Reason(*BHV_ReturnHome(params).Value(Seen(whole), now_), "overrun"), 10.0, 1e-9);
}

TEST_F(ViewBehaviorTest, CoverAreaPricesNewGroundBorderAndWayInMetres) {
  BHV_CoverArea::Params params;
  params.rates = {.cover = 2.0, .frontier = 0.25};
  const BHV_CoverArea behavior(params);
  const double swath = ground_.swath();
  const Bid bid = *behavior.Value(Seen(Straight(10.0), 3.0 * swath, 8.0), now_);
  EXPECT_NEAR(Reason(bid, "useful"), 6.0, 1e-12) << "three metres of full swath, twice";
  EXPECT_NEAR(Reason(bid, "ragged"), 2.0, 1e-12);
  EXPECT_NEAR(Reason(bid, "length"), 10.0, 1e-12);
  EXPECT_NEAR(bid.value, 6.0 - 2.0 - 10.0, 1e-12);
}

TEST_F(ViewBehaviorTest, CoverAreaLikesMoreGroundAndLessBorderAtEqualLength) {
  const BHV_CoverArea behavior({});
  Random random(1, "cover");
  for (int run = 0; run < 300; ++run) {
    const double area = random.Uniform(0.0, 50.0), border = random.Uniform(-20.0, 20.0);
    const Option& option = Straight(random.Uniform(0.5, 30.0));
    const double value = behavior.Value(Seen(option, area, border), now_)->value;
    EXPECT_GT(behavior.Value(Seen(option, area + 1.0, border), now_)->value, value);
    EXPECT_LT(behavior.Value(Seen(option, area, border + 1.0), now_)->value, value);
  }
}

TEST_F(ViewBehaviorTest, CoverAreaAsksItsSearchForWhatItWillPay) {
  const BHV_CoverArea behavior({});
  SearchGoals goals;
  behavior.Shape(now_, 3.0, goals);
  SeenAlong seen(ground_);
  const Option& option = Straight(12.0);
  const double searched = ValueOf(option.path, goals.objective, ground_, seen);
  const Bid bid = *behavior.Value(Prospect(option, seen(option.path)), now_);
  EXPECT_NEAR(searched, 3.0 * (Reason(bid, "useful") - Reason(bid, "ragged")) - 12.0, 1e-9);
}

TEST_F(ViewBehaviorTest, BehaviorsThatWantNewGroundWantItTogetherInWhateverOrder) {
  BHV_CoverArea::Params params;
  params.rates = {.cover = 2.0, .frontier = 0.25};
  const BHV_CoverArea cover(params), cover_more(params);
  const BHV_ReduceMapEntropy entropy({});
  const auto rates_of = [&](std::vector<std::pair<const Behavior*, double>> running) {
    SearchGoals goals;
    for (const auto& [behavior, weight] : running)
      behavior->Shape(now_, weight, goals);
    return goals.objective.ground;
  };
  const GroundRates both = rates_of({{&cover, 3.0}, {&entropy, 5.0}});
  const GroundRates turned = rates_of({{&entropy, 5.0}, {&cover, 3.0}});
  EXPECT_EQ(both.cover, 3.0 * 2.0 + 5.0);
  EXPECT_EQ(both.frontier, 3.0 * 0.25);
  EXPECT_EQ(turned.cover, both.cover);
  EXPECT_EQ(turned.frontier, both.frontier);
  EXPECT_EQ(rates_of({{&cover, 3.0}, {&cover_more, 1.0}}).frontier, 4.0 * 0.25);
}

TEST_F(ViewBehaviorTest, ReturnHomeCountsTheWayAlongTheOptionAndOnToHome) {
  now_.home = {.north = 6.0, .east = 8.0};
  const BHV_ReturnHome behavior({});
  const Bid bid = *behavior.Value(Seen(Straight(6.0)), now_);
  EXPECT_NEAR(bid.value, -(6.0 + 8.0), 1e-9);
  EXPECT_NEAR(Reason(bid, "to_go"), 14.0, 1e-9);
}

TEST_F(ViewBehaviorTest, ReturnHomeLikesWhatEndsNearerHomeForTheSameWay) {
  Random random(2, "home");
  const BHV_ReturnHome behavior({});
  for (int run = 0; run < 300; ++run) {
    now_.home = {.north = random.Uniform(-30.0, 30.0), .east = random.Uniform(-30.0, 30.0)};
    const double bearing = std::atan2(now_.home.east, now_.home.north);
    const double towards = behavior.Value(Seen(Straight(5.0, bearing)), now_)->value;
    const double aside =
        behavior.Value(Seen(Straight(5.0, bearing + random.Uniform(0.2, kPi))), now_)->value;
    EXPECT_GT(towards, aside);
  }
}

TEST_F(ViewBehaviorTest, ReturnHomeLateCostsNothingUntilTheRangeRunsOut) {
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

TEST_F(ViewBehaviorTest, ReturnHomeLateRefusesWhatTheBatteryDoesNotReachHomeAfter) {
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

TEST_F(ViewBehaviorTest, ReturnHomeLateAsksForAWayHomeInTime) {
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

TEST_F(ViewBehaviorTest, RevisitIsWorthLessTheLaterTheLook) {
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

TEST_F(ViewBehaviorTest, RevisitGivesNothingForAWayThatMissesTheObject) {
  now_.objects = {ObjectAt(10.0, 1.5, {.confirmed = 0.5, .removed = 0.5})};
  const BHV_RevisitOpi behavior({});
  EXPECT_EQ(behavior.Value(Seen(Straight(20.0)), now_)->value, 0.0);
  EXPECT_EQ(behavior.Value(Seen(Straight(8.0)), now_)->value, 0.0);
}

TEST_F(ViewBehaviorTest, RevisitHasNoOpinionOnceAllIsKnown) {
  now_.objects = {ObjectAt(10.0, 0.0, {.confirmed = 0.999, .removed = 0.001})};
  const BHV_RevisitOpi behavior({});
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_));
  now_.objects = {ObjectAt(10.0, 0.0, {.confirmed = 0.5, .removed = 0.5})};
  EXPECT_TRUE(behavior.Value(Seen(Straight(20.0)), now_));
  now_.objects[0].belief.looks = 2;
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_)) << "looked at often enough";
  now_.objects[0].belief.looks = 0;
  now_.objects[0].window.reset();
  EXPECT_FALSE(behavior.Value(Seen(Straight(20.0)), now_)) << "not seen from survey altitude";
}

TEST_F(ViewBehaviorTest, RevisitIsWorthTheSumOfItsObjectsWhateverTheirOrder) {
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

TEST_F(ViewBehaviorTest, MapEntropyIsAsManyNatsAsTheImageHasUnseenCells) {
  const BHV_ReduceMapEntropy behavior({});
  const Bid bid = *behavior.Value(Seen(Straight(10.0)), now_);
  const double image = 4.0 * ground_.footprint().half_along(0) * ground_.footprint().half_across(0);
  const double cells = image / (ground_.frame().cell_m * ground_.frame().cell_m);
  EXPECT_NEAR(Reason(bid, "map_entropy"), cells * std::numbers::ln2, 0.06 * cells);
  EXPECT_NEAR(bid.value, std::log(Reason(bid, "map_entropy")), 1e-9);
}

TEST_F(ViewBehaviorTest, MapEntropyCountsAViewTwiceThatIsTakenTwice) {
  const BHV_ReduceMapEntropy behavior({});
  Option option = Straight(10.0);
  option.views = {option.path.end()};
  const double once = Reason(*behavior.Value(Seen(option), now_), "map_entropy");
  option.views.push_back(option.path.end());
  EXPECT_NEAR(Reason(*behavior.Value(Seen(option), now_), "map_entropy"), 2.0 * once, 1e-9);
}

TEST_F(ViewBehaviorTest, MapEntropyStaysFiniteWhereTheImageShowsNothingOfTheArea) {
  const BHV_ReduceMapEntropy behavior({});
  Option option{.source = "paper", .path = DubinsPath({500.0, 500.0, 0.0}, {{0.0, 1.0}})};
  EXPECT_TRUE(std::isfinite(behavior.Value(Seen(option), now_)->value));
}

TEST_F(ViewBehaviorTest, ObjectEntropyCountsObjectsInsideTheImageAlone) {
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

TEST_F(ViewBehaviorTest, InheritedObjectsCountLessTheMoreIsCovered) {
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

TEST_F(ViewBehaviorTest, OpRegionVetoesExactlyWhatLeavesTheRegion) {
  const BHV_OpRegion behavior({});
  Random random(3, "region");
  int vetoes = 0;
  for (int run = 0; run < 500; ++run) {
    now_.pose = {random.Uniform(-38.0, 38.0), random.Uniform(-38.0, 38.0),
                 random.Uniform(-kPi, kPi)};
    const Option option{.source = "beam",
                        .path = DubinsPath(now_.pose, {{random.Uniform(-0.3, 0.3), 12.0},
                                                       {random.Uniform(-0.3, 0.3), 12.0}})};
    bool leaves = false;
    double nearest = 1e9;  // to the border, by small steps
    option.path.Sample(0.05, [&](const Pose2& pose, double) {
      const double beyond = std::max(std::abs(pose.north), std::abs(pose.east)) - 42.0;
      leaves = leaves || beyond > 0.0;
      nearest = std::min(nearest, std::abs(beyond));
    });
    const bool has_veto = behavior.Value(Seen(option), now_)->veto.has_value();
    vetoes += has_veto ? 1 : 0;
    if (nearest > 0.01) {
      EXPECT_EQ(has_veto, leaves);
    }
  }
  EXPECT_GT(vetoes, 50);
  EXPECT_LT(vetoes, 450);
}

}  // namespace
}  // namespace limpet
