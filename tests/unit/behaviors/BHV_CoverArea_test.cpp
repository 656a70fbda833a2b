// SPDX-License-Identifier: MIT
// Bids of BHV_CoverArea on options, against geometry done by hand.
#include "behaviors/BHV_CoverArea.hpp"

#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "behaviors/BHV_ReduceMapEntropy.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

using BhvCoverArea = ViewBehaviorTest;

TEST_F(BhvCoverArea, PrefersTheWholeThatShowsGroundSooner) {
  Option& whole = Straight(100.0);
  whole.own_m = 25.0;
  const BHV_CoverArea cover({.rates = {.cover = 1.0, .frontier = 0.0, .early = 1.0}});
  const double area = ground_.wanted_m2();
  const Prospect soon(whole, {.new_area = 50.0, .delay = 10.0 * area});
  const Prospect late(whole, {.new_area = 50.0, .delay = 30.0 * area});
  EXPECT_NEAR(cover.Value(soon, now_)->value - cover.Value(late, now_)->value, 20.0, 1e-9);
  EXPECT_NEAR(Reason(*cover.Value(late, now_), "length"), 100.0, 1e-9);
}

TEST_F(BhvCoverArea, DoesNotAskWhenAnOptionThatIsNoWholeShowsIt) {
  const BHV_CoverArea cover({.rates = {.cover = 1.0, .frontier = 0.0, .early = 1.0}});
  const Prospect part(Straight(20.0), {.new_area = 50.0, .delay = 500.0});
  EXPECT_EQ(cover.Value(part, now_)->why.size(), 3U);
}

TEST_F(BhvCoverArea, ChargesForTheCurrentAndSaysSo) {
  const BHV_CoverArea cover({});
  const double still = cover.Value(Seen(Straight(40.0)), now_)->value;
  now_.course_cost.metres = {1.5, 1.1, 0.7, 1.1};
  const Bid against = *cover.Value(Seen(Straight(40.0)), now_);
  EXPECT_NEAR(still - against.value, 20.0, 1e-9);
  EXPECT_NEAR(Reason(against, "current"), 20.0, 1e-9);
  EXPECT_NEAR(cover.Value(Seen(Straight(40.0, std::numbers::pi)), now_)->value - still, 12.0, 1e-9);
}

TEST_F(BhvCoverArea, PricesNewGroundBorderAndWayInMetres) {
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

/// Entropy of all that an image may show: a height above a cell that has not been seen holds as
/// much as can be, one that has what OctoMap's clamp leaves [nats].
double MapEntropy(const Ground& ground) {
  constexpr double kSeen = 0.13;
  double nats = 0.0;
  for (const std::uint8_t level : ground.levels()) {
    for (int layer = 0; layer < Footprint::kLayers; ++layer) {
      nats += ground.weights()[static_cast<std::size_t>(layer)] *
              (layer < level ? kSeen : std::numbers::ln2);
    }
  }
  return nats;
}

SurveyGrid Flown(const SurveyGrid& before, const DubinsPath& path) {
  SurveyGrid after = before.Blank();
  static_cast<void>(after.Apply(before.Everything()));
  scene::Fly(after, path);
  return after;
}

double EntropyDrop(const SurveyGrid& before, const DubinsPath& path) {
  return MapEntropy(Ground(before, scene::TableFootprint())) -
         MapEntropy(Ground(Flown(before, path), scene::TableFootprint()));
}

TEST_F(BhvCoverArea, BidsTheDropOfTheMapsEntropyByThatOfAMetreOfFullyUsefulTrack) {
  const BHV_CoverArea behavior({});
  const auto straight = [](double length) {
    return DubinsPath({-12.0, 8.0, 0.0}, {{.curvature = 0.0, .length = length}});
  };
  const SurveyGrid unseen(scene::kArea);
  const double nats_per_metre =
      (EntropyDrop(unseen, straight(20.0)) - EntropyDrop(unseen, straight(10.0))) / 10.0;
  const SurveyGrid half_seen =
      Flown(unseen, DubinsPath({-14.0, -1.0, 0.1}, {{.curvature = 0.0, .length = 25.0}}));
  Random random(17, "entropy");
  for (int run = 0; run < 40; ++run) {
    const Pose2 start{random.Uniform(-8.0, 8.0), random.Uniform(-10.0, 10.0),
                      random.Uniform(-3.0, 3.0)};
    const Option option{.source = "beam",
                        .path = DubinsPath(start, {{random.Uniform(-0.3, 0.3), 6.0}, {0.0, 4.0}})};
    const SurveyGrid here = Flown(half_seen, DubinsPath(start));  // where it is, it has seen
    const Ground ground(here, scene::TableFootprint());
    SeenAlong seen(ground);
    now_.ground = &ground;
    const Bid bid = *behavior.Value(Prospect(option, seen(option.path)), now_);
    EXPECT_NEAR(Reason(bid, "useful"), EntropyDrop(here, option.path) / nats_per_metre, 0.4)
        << "run " << run;
  }
}

TEST_F(BhvCoverArea, LikesMoreGroundAndLessBorderAtEqualLength) {
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

TEST_F(BhvCoverArea, AsksItsSearchForWhatItWillPay) {
  const BHV_CoverArea behavior({});
  SearchGoals goals;
  behavior.Shape(now_, 3.0, goals);
  SeenAlong seen(ground_);
  const Option& option = Straight(12.0);
  const double searched = ValueOf(option.path, goals.objective, ground_, seen);
  const Bid bid = *behavior.Value(Prospect(option, seen(option.path)), now_);
  EXPECT_NEAR(searched, 3.0 * (Reason(bid, "useful") - Reason(bid, "ragged")) - 12.0, 1e-9);
}

TEST_F(BhvCoverArea, BehaviorsThatWantNewGroundWantItTogetherInWhateverOrder) {
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

INSTANTIATE_TYPED_TEST_SUITE_P(BhvCoverArea, EveryBehavior, BHV_CoverArea);

}  // namespace
}  // namespace limpet
