// SPDX-License-Identifier: MIT
#include "limpet/planning/tour_search.hpp"

#include <gtest/gtest.h>

#include "limpet/planning/lane_tours.hpp"
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

TEST(TourSearch, LooksAtATargetSoonIfThatIsWorthIt) {
  SearchProblem problem;
  const PlanePoint at(10.0, 10.0);
  TourGoal goal;
  goal.targets = {{.north = at.x(), .east = at.y(), .window = {1.5, 1.5}, .value = 200.0}};
  problem.judge.Reset(DubinsPath(scene::kStart), goal);
  SurveyTour tour = LaneTours(problem.judge, {}).front();
  TourSearch search(Meters(4.0), Random(2));
  EXPECT_GT(search.Improve(problem.judge, tour, 2000).looks, 90.0);
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
