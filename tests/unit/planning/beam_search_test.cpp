// SPDX-License-Identifier: MIT
#include "limpet/planning/beam_search.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/view_tree.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet::scene {
namespace {

TEST(BeamSearch, OffersPathsThatStayInsideAndRecoverable) {
  const HalfSeen scene;
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    Pose2 start{random.Uniform(-17.0, 17.0), random.Uniform(-20.0, 20.0),
                random.Uniform(-std::numbers::pi, std::numbers::pi)};
    if (!kSceneRegion.IsRecoverable(start, kRadius)) {
      continue;
    }
    const auto offers = BeamSearch(start, scene.ground, kSceneRegion, Defaults(), {.width = 10});
    ASSERT_FALSE(offers.empty());
    for (const Option& option : offers) {
      EXPECT_TRUE(kSceneRegion.Contains(option.path));
      EXPECT_TRUE(kSceneRegion.IsRecoverable(option.path.end(), kRadius));
      EXPECT_NEAR(option.path.length(), 25.0, 1e-6);
    }
  }
}

TEST(BeamSearch, IsDeterministic) {
  const HalfSeen scene;
  ExpectSame(BeamSearch(kStart, scene.ground, kSceneRegion, Defaults(), {}),
             BeamSearch(kStart, scene.ground, kSceneRegion, Defaults(), {}));
}

TEST(BeamSearch, ItsEstimateIsTheObjectiveOfItsPath) {
  const HalfSeen scene;
  Objective objective = Defaults();
  objective.targets = {{.north = -3.0, .east = -12.0, .window = {1.5, 1.5}, .value = 30.0}};
  SeenAlong seen(scene.ground);
  for (const Option& option :
       BeamSearch(kStart, scene.ground, kSceneRegion, objective, {.offers = 5})) {
    // Joined segments are sampled at other places than single motions: a few cells differ.
    EXPECT_NEAR(option.estimate, ValueOf(option.path, objective, scene.ground, seen), 1.5);
  }
}

TEST(BeamSearch, OffersAtLeastADozenPathsThatDifferAfterTenMetresBestFirst) {
  const HalfSeen scene;
  for (const Pose2& start : {kStart, Pose2{0.0, 0.0, 1.0}, Pose2{8.0, -10.0, -2.0}}) {
    const auto offers = BeamSearch(start, scene.ground, kSceneRegion, Defaults(), {});
    EXPECT_GE(offers.size(), 12U);
    for (std::size_t i = 1; i < offers.size(); ++i) {
      EXPECT_GE(offers[i - 1].estimate, offers[i].estimate);
      for (std::size_t j = 0; j < i; ++j) {
        const Pose2 a = offers[i].path.At(10.0), b = offers[j].path.At(10.0);
        EXPECT_GT(Distance(a, b) + std::abs(WrapAngle(a.yaw - b.yaw)), 0.5) << i << ", " << j;
      }
    }
  }
}

TEST(BeamSearch, ItsBestIsTheSameHoweverManyOthersItOffers) {
  const HalfSeen scene;
  const auto one = BeamSearch(kStart, scene.ground, kSceneRegion, Defaults(), {.offers = 1});
  const auto many = BeamSearch(kStart, scene.ground, kSceneRegion, Defaults(), {.offers = 30});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.front().estimate, many.front().estimate);
  EXPECT_LT(Distance(one.front().path.end(), many.front().path.end()), 1e-9);
}

/// Metres flown north of the origin, and a prize for crossing that line first.
class NorthTerm final : public SearchTerm {
 public:
  explicit NorthTerm(double prize = 0.0) : prize_(prize) {}
  [[nodiscard]] std::size_t event_count() const override { return 1; }
  [[nodiscard]] double Worth(const PathStep& step, TermEvents& events) const override {
    double worth = 0.0, last = step.before;
    step.Sample([&](const Pose2& pose, double s) {
      worth += pose.north > 0.0 ? s - last : 0.0;
      last = s;
      if (pose.north > 0.0 && !events.Has(0)) {
        events.Add(0);
        worth += prize_;
      }
    });
    return worth;
  }

 private:
  double prize_;
};

TEST(SearchTerm, OfABehaviorDrawsEverySearchWhereItWants) {
  const HalfSeen scene;
  const Pose2 start{-4.0, 0.0, 0.5 * std::numbers::pi};
  Objective objective = Defaults();
  const Option plain = BeamSearch(start, scene.ground, kSceneRegion, objective, {}).front();
  objective.ground = {};
  objective.terms = {std::make_shared<NorthTerm>()};
  const Option drawn = BeamSearch(start, scene.ground, kSceneRegion, objective, {}).front();
  EXPECT_GE(WorthAlong(drawn.path, NorthTerm()), WorthAlong(plain.path, NorthTerm()));
  EXPECT_GT(WorthAlong(drawn.path, NorthTerm()), 18.0);  // of 25 m
  Random random(2);
  const Option branch = ViewTree(start, scene.ground, kSceneRegion, objective, {}, random).front();
  EXPECT_GT(WorthAlong(branch.path, NorthTerm()), 0.5 * branch.path.length());
}

TEST(SearchTerm, CountsItsEventsOncePerPath) {
  const HalfSeen scene;
  Objective objective;
  objective.terms = {std::make_shared<NorthTerm>(100.0)};
  SeenAlong seen(scene.ground);
  for (const Option& option :
       BeamSearch({-4.0, 0.0, 0.0}, scene.ground, kSceneRegion, objective, {})) {
    EXPECT_LT(option.estimate, 126.0);
    EXPECT_NEAR(option.estimate, ValueOf(option.path, objective, scene.ground, seen), 1.5);
  }
}

TEST(BeamSearch, GoesToAValuableTargetFirst) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, TableFootprint());
  Objective objective = Defaults();
  objective.targets = {{.north = -6.0, .east = -5.0, .window = {1.5, 1.5}, .value = 80.0}};
  const auto offers = BeamSearch(kStart, ground, kSceneRegion, objective, {});
  ASSERT_FALSE(offers.empty());
  EXPECT_GT(TargetValueOf(offers.front().path, objective), 60.0);
}

TEST(BeamSearch, BringsADriftedVehicleBack) {
  const HalfSeen scene;
  const Pose2 outside{17.8, 0.0, 0.0};
  const auto offers = BeamSearch(outside, scene.ground, kSceneRegion, Defaults(), {});
  ASSERT_FALSE(offers.empty());
  EXPECT_TRUE(kSceneRegion.IsRecoverable(offers.front().path.end(), kRadius));
}

TEST(BeamSearch, CoversTable1WithinTheRequiredPath) {
  SurveyGrid grid(kArea);
  Ground ground(grid, TableFootprint());
  Objective objective;
  objective.ground = {.cover = 1.0, .frontier = 0.325};  // best of this search alone
  Pose2 pose = kStart;
  double path = 0.0;
  while (grid.coverage().seabed < 0.95 && path < 300.0) {
    ground.Update(grid);
    const DubinsPath leg =
        BeamSearch(pose, ground, kSceneRegion, objective, {}).front().path.Prefix(8.0);
    Fly(grid, leg);
    pose = leg.end();
    path += leg.length();
  }
  EXPECT_LE(path, 250.0);
}

TEST(BeamSearch, SeesEveryTargetHoweverManyThereAre) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, TableFootprint());
  Objective objective = Defaults();
  objective.ground = {.cover = 0.0, .frontier = 0.0};
  for (int i = 0; i < 40; ++i) {  // of no worth, and first in the list
    objective.targets.push_back({.north = 14.0, .east = 17.0, .window = {0.5, 0.5}});
  }
  objective.targets.push_back({.north = -12.5, .east = 0.0, .window = {1.5, 1.5}, .value = 80.0});
  const auto offers = BeamSearch(kStart, ground, kSceneRegion, objective, {});
  ASSERT_FALSE(offers.empty());
  EXPECT_GT(TargetValueOf(offers.front().path, objective), 60.0);
}

}  // namespace
}  // namespace limpet::scene
