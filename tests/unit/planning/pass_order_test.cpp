// SPDX-License-Identifier: MIT
#include "limpet/planning/pass_order.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/tour_path.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

/// Way through `tour` and home.
double WayThrough(const SurveyTour& tour, const TourJudge& judge) {
  const DubinsPath path =
      Fly(DubinsPath(judge.start()), tour, judge.region(), judge.turn_radius()).path;
  return path.length() + std::hypot(path.end().north, path.end().east);
}

std::vector<Pass> LanesApart(double spacing, int count) {
  std::vector<Pass> lanes;
  for (int i = 0; i < count; ++i) {
    lanes.push_back({.in = {-10.0 + spacing * i, -12.0, 1.5707963}, .length = 24.0});
  }
  return lanes;
}

struct OrderProblem {
  OrderProblem() { judge.Reset(DubinsPath(scene::kStart), {}); }
  scene::HalfSeen half;
  TourJudge judge{half.ground, scene::kSceneRegion, scene::kRadius};
};

TEST(PassOrder, IsAsShortAsTheBestOfAllOrdersAndDirections) {
  OrderProblem problem;
  const std::vector<Pass> lanes = LanesApart(3.3, 4);
  double least = 1e9;
  std::vector<std::size_t> order{0, 1, 2, 3};
  do {
    for (unsigned directions = 0; directions < 16; ++directions) {
      SurveyTour tour;
      for (const std::size_t i : order) {
        tour.push_back((directions >> i & 1U) != 0 ? lanes[i].Reversed() : lanes[i]);
      }
      least = std::min(least, WayThrough(tour, problem.judge));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const SurveyTour best = InBestOrder(problem.judge, problem.judge.start(), lanes);
  EXPECT_NEAR(WayThrough(best, problem.judge), least, 1e-6);
}

TEST(PassOrder, HoldsEveryPassOfMany) {
  OrderProblem problem;
  EXPECT_EQ(InBestOrder(problem.judge, problem.judge.start(), LanesApart(1.3, 16)).size(), 16U);
}

TEST(PassOrder, OfNothingIsNothing) {
  OrderProblem problem;
  EXPECT_TRUE(InBestOrder(problem.judge, problem.judge.start(), {}).empty());
}

}  // namespace
}  // namespace limpet
