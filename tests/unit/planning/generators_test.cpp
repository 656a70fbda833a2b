// SPDX-License-Identifier: MIT
// What every generator of options must keep to: inside, recoverable, deterministic, useful.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/planning/beam_search.hpp"
#include "limpet/planning/gap_paths.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/paper_planner.hpp"
#include "limpet/planning/target_tour.hpp"
#include "limpet/planning/view_tree.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

using scene::kArea;
using scene::kRadius;

const Region kSceneRegion(kArea);
const Pose2 kStart{-12.5, -15.5, 0.5 * std::numbers::pi};

/// A grid on which a few lanes have been flown, and its ground.
struct HalfSeen {
  HalfSeen() {
    for (const double north : {-13.0, -9.5, -6.0}) {
      scene::Fly(grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
    }
    ground.Update(grid);
  }
  SurveyGrid grid{kArea};
  Ground ground{grid, scene::TableFootprint()};
};

Objective Defaults() {
  Objective objective;
  objective.w_frontier = 0.2;
  return objective;
}

void ExpectSame(const std::vector<Option>& a, const std::vector<Option>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].estimate, b[i].estimate);
    EXPECT_EQ(a[i].path.end().north, b[i].path.end().north);
    EXPECT_EQ(a[i].path.segments().size(), b[i].path.segments().size());
  }
}

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
  SightAlong sight(scene.ground);
  for (const Option& option :
       BeamSearch(kStart, scene.ground, kSceneRegion, objective, {.offers = 5})) {
    // Joined segments are sampled at other places than single motions: a few cells differ.
    EXPECT_NEAR(option.estimate, ValueOf(option.path, objective, scene.ground, sight), 1.5);
  }
}

TEST(BeamSearch, OffersAreOrderedAndOpenDifferently) {
  const HalfSeen scene;
  const auto offers = BeamSearch(kStart, scene.ground, kSceneRegion, Defaults(), {.offers = 3});
  ASSERT_EQ(offers.size(), 3U);
  EXPECT_GE(offers[0].estimate, offers[1].estimate);
  EXPECT_GE(offers[1].estimate, offers[2].estimate);
  const Pose2 a = offers[0].path.At(5.0), b = offers[1].path.At(5.0);
  EXPECT_GT(Distance(a, b) + std::abs(a.yaw - b.yaw), 0.1);
}

TEST(BeamSearch, GoesToAValuableTargetFirst) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
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
  Ground ground(grid, scene::TableFootprint());
  Pose2 pose = kStart;
  double path = 0.0;
  while (grid.coverage().seabed < 0.95 && path < 300.0) {
    ground.Update(grid);
    const DubinsPath leg =
        BeamSearch(pose, ground, kSceneRegion, Objective{}, {}).front().path.Prefix(8.0);
    scene::Fly(grid, leg);
    pose = leg.end();
    path += leg.length();
  }
  EXPECT_LE(path, 250.0);
}

TEST(GapPaths, ReachAPatchFarBeyondTheBeamsHorizon) {
  SurveyGrid grid(kArea);
  for (double north = -15.0; north <= 15.5; north += 2.0) {
    // All lanes but the last 6 m of the most north-eastern ones.
    const double length = north > 11.0 ? 30.0 : 36.0;
    scene::Fly(grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, length}}));
  }
  const Ground ground(grid, scene::TableFootprint());
  const auto offers = GapPaths(kStart, ground, kSceneRegion, Defaults(), {.finish_share = 1.0});
  ASSERT_FALSE(offers.empty());
  SightAlong sight(ground);
  EXPECT_GT(sight(offers.front().path).new_area, 1.0);
  EXPECT_TRUE(kSceneRegion.Contains(offers.front().path));
}

TEST(GapPaths, OfferNothingWhenAllIsSeen) {
  SurveyGrid grid(kArea);
  for (double north = -15.0; north <= 15.5; north += 2.0) {
    scene::Fly(grid, DubinsPath({north, -20.0, 0.5 * std::numbers::pi}, {{0.0, 40.0}}));
  }
  const Ground ground(grid, scene::TableFootprint());
  EXPECT_TRUE(GapPaths(kStart, ground, kSceneRegion, Defaults(), {}).empty());
}

TEST(TargetTours, PassesEveryFormerObjectOfTable1Early) {
  Objective objective;
  for (const auto& [north, east] :
       {std::pair{4.0, 1.0}, std::pair{2.0, 10.0}, std::pair{6.0, -3.0}, std::pair{-6.0, -5.0}}) {
    objective.targets.push_back({.north = north, .east = east, .window = {1.5, 1.5}, .value = 1.0});
  }
  objective.target_decay_m = 1e9;
  const std::vector<Option> tours = TargetTours(kStart, kSceneRegion, objective, kRadius);
  ASSERT_EQ(tours.size(), 1U);
  EXPECT_NEAR(TargetValueOf(tours.front().path, objective), 4.0, 1e-6);
  EXPECT_LT(tours.front().path.length(), 45.0);
  EXPECT_TRUE(kSceneRegion.Contains(tours.front().path));
}

/// Targets on a square grid, 3 m apart.
Objective ManyTargets(int rows, int columns) {
  Objective objective;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      objective.targets.push_back({.north = -12.0 + 3.0 * row,
                                   .east = -15.0 + 3.0 * column,
                                   .window = {1.5, 1.5},
                                   .value = 5.0});
    }
  }
  objective.target_decay_m = 1e6;
  return objective;
}

TEST(TargetTours, GoOnBeyondTheFirstEightStops) {
  const Objective objective = ManyTargets(5, 6);
  const std::vector<Option> tours = TargetTours(kStart, kSceneRegion, objective, kRadius);
  ASSERT_EQ(tours.size(), 4U);
  EXPECT_NEAR(TargetValueOf(tours.back().path, objective), 30 * 5.0, 1.0);
  EXPECT_TRUE(kSceneRegion.Contains(tours.back().path));
}

TEST(TargetTours, EndWhereALookIsWorthNothingAnyMore) {
  Objective objective = ManyTargets(5, 6);
  objective.target_decay_m = 20.0;
  EXPECT_EQ(TargetTours(kStart, kSceneRegion, objective, kRadius).size(), 1U);
}

TEST(TargetTours, LookFromTheBorderAtWhatLiesBeyondIt) {
  const Target beside{.north = 18.5, .east = 0.0, .window = {1.0, 2.0}};  // 1.5 m outside
  EXPECT_TRUE(CanBeLookedAt(beside, kSceneRegion, kRadius));
  const Target beyond{.north = 20.0, .east = 0.0, .window = {1.0, 2.0}};
  EXPECT_FALSE(CanBeLookedAt(beyond, kSceneRegion, kRadius));
}

TEST(BeamSearch, SeesEveryTargetHoweverManyThereAre) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  Objective objective = Defaults();
  objective.w_cover = objective.w_frontier = 0.0;
  for (int i = 0; i < 40; ++i) {  // of no worth, and first in the list
    objective.targets.push_back({.north = 14.0, .east = 17.0, .window = {0.5, 0.5}});
  }
  objective.targets.push_back({.north = -12.5, .east = 0.0, .window = {1.5, 1.5}, .value = 80.0});
  const auto offers = BeamSearch(kStart, ground, kSceneRegion, objective, {});
  ASSERT_FALSE(offers.empty());
  EXPECT_GT(TargetValueOf(offers.front().path, objective), 60.0);
}

TEST(TargetTours, IsNothingWithoutTargets) {
  EXPECT_TRUE(TargetTours(kStart, kSceneRegion, Objective{}, kRadius).empty());
}

TEST(HomePath, EndsAtHomeAndStaysInside) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Pose2 start{random.Uniform(-12.0, 12.0), random.Uniform(-15.0, 15.0),
                      random.Uniform(-std::numbers::pi, std::numbers::pi)};
    const Option home = HomePath(start, -12.5, -15.5, kSceneRegion, kRadius);
    EXPECT_NEAR(home.path.end().north, -12.5, 1e-6);
    EXPECT_NEAR(home.path.end().east, -15.5, 1e-6);
    EXPECT_TRUE(kSceneRegion.Contains(home.path));
  }
}

TEST(HomePath, IsNotMuchLongerThanTheStraightLine) {
  const Option home = HomePath({10.0, 10.0, 0.0}, -12.5, -15.5, kSceneRegion, kRadius);
  EXPECT_LT(home.path.length(), std::hypot(22.5, 25.5) + 12.0);
}

TEST(ViewTree, OffersPathsThatStayInsideAndRecoverable) {
  const HalfSeen scene;
  Random random(4);
  const auto offers = ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, random);
  ASSERT_FALSE(offers.empty());
  for (const Option& option : offers) {
    EXPECT_TRUE(kSceneRegion.Contains(option.path));
    EXPECT_TRUE(kSceneRegion.IsRecoverable(option.path.end(), kRadius));
  }
}

TEST(ViewTree, ItsEstimateIsTheObjectiveOfItsPath) {
  const HalfSeen scene;
  const Objective objective = Defaults();
  Random random(5);
  SightAlong sight(scene.ground);
  for (const Option& option : ViewTree(kStart, scene.ground, kSceneRegion, objective, {}, random)) {
    EXPECT_NEAR(option.estimate, ValueOf(option.path, objective, scene.ground, sight), 1.5);
  }
}

TEST(ViewTree, IsDeterministicForASeed) {
  const HalfSeen scene;
  Random one(6), two(6);
  ExpectSame(ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, one),
             ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, two));
}

TEST(ViewTree, RewiringDoesNotMakeTheBestBranchWorse) {
  const HalfSeen scene;
  double with = 0.0, without = 0.0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Random one(seed), two(seed);
    with += ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), {}, one).front().estimate;
    ViewTreeParams plain;
    plain.rewire_radius = Meters(0.0);
    without +=
        ViewTree(kStart, scene.ground, kSceneRegion, Defaults(), plain, two).front().estimate;
  }
  EXPECT_GE(with, without - 1.0);
}

TEST(SeenDensity, IsHighestWhereMostHasBeenSeen) {
  const HalfSeen scene;
  const SeenDensity density(scene.ground);
  EXPECT_GT(density.At(-9.5, 0.0), 0.8);
  EXPECT_LT(density.At(10.0, 0.0), 0.05);
}

TEST(SeenDensity, SamplesFallWhereLittleHasBeenSeen) {
  const HalfSeen scene;
  const SeenDensity density(scene.ground);
  Random random(7);
  int in_the_unseen_north = 0;
  for (int i = 0; i < 1000; ++i) {
    in_the_unseen_north += density.Sample(kSceneRegion, random).north > -2.0 ? 1 : 0;
  }
  EXPECT_GT(in_the_unseen_north, 700);  // 56 % of the region
}

TEST(PaperPlanner, FliesToViewsInsideTheRegion) {
  SurveyGrid grid(kArea);
  Ground ground(grid, scene::TableFootprint());
  PaperPlanner planner({}, kSceneRegion, Random(8));
  Pose2 pose = kStart;
  for (int i = 0; i < 15; ++i) {
    ground.Update(grid);
    const auto next = planner.Next(pose, ground, {}, 0.0);
    ASSERT_TRUE(next.has_value());
    ASSERT_TRUE(kSceneRegion.Contains(next->path));
    scene::Fly(grid, next->path);
    pose = next->path.end();
  }
  EXPECT_GT(grid.coverage().seabed, 0.3);
}

TEST(PaperPlanner, ValuesInheritedObjectsInAChangeSession) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  OpiBelief former;
  former.prior_id = 1;
  former.ned = {-12.0, -10.0, 6.5};
  former.probability = 0.6;
  PaperParams params;
  params.gain = PaperGain::kChange;
  PaperPlanner with(params, kSceneRegion, Random(9)), without(params, kSceneRegion, Random(9));
  static_cast<void>(with.Next(kStart, ground, {former}, 0.0));
  static_cast<void>(without.Next(kStart, ground, {}, 0.0));
  EXPECT_GT(with.log_gain(), without.log_gain());
}

}  // namespace
}  // namespace limpet
