// SPDX-License-Identifier: MIT
#include "limpet/planning/tour_search.hpp"

#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/planning/lane_tours.hpp"
#include "limpet/planning/tour_path.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

struct SearchProblem {
  SearchProblem() { judge.Reset(DubinsPath(scene::kStart), {}); }
  SurveyGrid grid{scene::kArea};
  Ground ground{grid, scene::TableFootprint()};
  TourJudge judge{ground, scene::kSceneRegion, scene::kRadius};
};

TEST(TourSearch, NeverMakesATourWorse) {
  SearchProblem problem;
  SurveyTour tour = LaneTours(problem.judge, {}).front();
  double before = problem.judge.Cost(tour).total;
  TourSearch search(Meters(4.0), Random(2));
  for (int round = 0; round < 4; ++round) {
    const double after = search.Improve(problem.judge, tour, 100).total;
    EXPECT_LE(after, before);
    EXPECT_EQ(problem.judge.Cost(tour).total, after);
    before = after;
  }
}

/// Path to the first look at a target of `value`, mean over tours sought for it.
double WayToATargetWorth(double value) {
  constexpr int kSearches = 5;
  const Target target{.north = 10.0, .east = 10.0, .window = {1.5, 1.5}, .value = value};
  TourGoal goal;
  goal.early_weight = 1.0;
  goal.most_weight = 0.0;
  goal.others.targets = {target};
  double sum = 0.0;
  for (int i = 0; i < kSearches; ++i) {
    SearchProblem problem;
    problem.judge.Reset(DubinsPath(scene::kStart), goal);
    SurveyTour tour = LaneTours(problem.judge, {}).front();
    const auto seed = static_cast<std::uint64_t>(i + 1);
    TourSearch(Meters(4.0), Random(seed)).Improve(problem.judge, tour, 1000);
    const DubinsPath path =
        Fly(DubinsPath(scene::kStart), tour, scene::kSceneRegion, scene::kRadius).path;
    sum += FirstLook(path, target).value();
  }
  return sum / kSearches;
}

TEST(TourSearch, LooksAtATargetSoonerIfThatIsWorthMore) {
  EXPECT_LT(WayToATargetWorth(200.0) + 50.0, WayToATargetWorth(0.0));
}

/// Path until most of the band's top has been seen, mean over tours sought for that.
double WayToMost(double weight) {
  constexpr int kSearches = 5;
  TourGoal goal;
  goal.early_weight = 0.0;
  goal.most_weight = weight;
  double sum = 0.0;
  for (int i = 0; i < kSearches; ++i) {
    SearchProblem problem;
    problem.judge.Reset(DubinsPath(scene::kStart), goal);
    SurveyTour tour = LaneTours(problem.judge, {.with_bottom_first = false}).front();
    TourSearch search(Meters(4.0), Random(static_cast<std::uint64_t>(i)));
    sum += search.Improve(problem.judge, tour, 2000).most;
  }
  return sum / kSearches;
}

/// Where all is seen, no pass is added for the ground's sake; and the tour leads elsewhere.
TEST(TourSearch, LooksAtATargetOnGroundThatHasBeenSeen) {
  SearchProblem problem;
  for (const double north : {6.0, 9.0, 12.0}) {
    scene::Fly(problem.grid, DubinsPath({north, -18.0, 0.5 * std::numbers::pi}, {{0.0, 36.0}}));
  }
  problem.ground.Update(problem.grid);
  TourGoal goal;
  goal.others.targets = {{.north = 9.0, .east = 12.0, .window = {1.0, 1.0}, .value = 600.0}};
  problem.judge.Reset(DubinsPath(scene::kStart), goal);
  const SurveyTour lanes = LaneTours(problem.judge, {}).front();
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    SurveyTour tour = lanes;
    TourSearch(Meters(8.0), Random(seed)).Improve(problem.judge, tour, 400);
    const DubinsPath path =
        Fly(DubinsPath(scene::kStart), tour, scene::kSceneRegion, scene::kRadius).path;
    EXPECT_TRUE(FirstLook(path, goal.others.targets[0])) << "seed " << seed;
  }
}

TEST(TourSearch, LeavesSliversForTheEndIfMostIsToBeSeenSoon) {
  const double soon = WayToMost(3.0), whenever = WayToMost(0.0);
  EXPECT_LT(soon + 10.0, whenever) << soon;
}

TEST(TourSearch, MakesATourOfNothing) {
  SearchProblem problem;
  SurveyTour tour;
  TourSearch search(Meters(4.0), Random(2));
  search.Improve(problem.judge, tour, 500);
  EXPECT_FALSE(tour.empty());
}

}  // namespace
}  // namespace limpet
