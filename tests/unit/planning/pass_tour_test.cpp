// SPDX-License-Identifier: MIT
#include "limpet/planning/pass_tour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/unseen_patches.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

const Region kTourRegion(scene::kArea);

Stop AnyHeading(double north, double east) {
  Stop stop;
  for (int i = 0; i < 8; ++i) {
    stop.push_back({.in = {north, east, 0.25 * std::numbers::pi * i}, .length = 1.0});
  }
  return stop;
}

std::vector<Stop> RandomStops(Random& random, int count) {
  std::vector<Stop> stops;
  for (int i = 0; i < count; ++i) {
    stops.push_back(AnyHeading(random.Uniform(-10.0, 10.0), random.Uniform(-12.0, 12.0)));
  }
  return stops;
}

TEST(PassTour, VisitsEveryStopOnce) {
  Random random(1);
  const PassTour tour = PlanPassTour({}, RandomStops(random, 7), kTourRegion, scene::kRadius);
  std::vector<std::size_t> order = tour.order;
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(PassTour, PassesTheStopsWhereItSays) {
  Random random(2);
  const std::vector<Stop> stops = RandomStops(random, 6);
  const PassTour tour = PlanPassTour({}, stops, kTourRegion, scene::kRadius);
  for (std::size_t i = 0; i < tour.order.size(); ++i) {
    const Pose2 before_out = tour.path.At(tour.reached[i] - 1.0);
    EXPECT_NEAR(Distance(before_out, stops[tour.order[i]].front().in), 0.0, 1e-6);
  }
}

TEST(PassTour, FindsTheBestOrderOfAFewStops) {
  Random random(3);
  for (int trial = 0; trial < 5; ++trial) {
    const std::vector<Stop> stops = RandomStops(random, 4);
    const double found = PlanPassTour({}, stops, kTourRegion, scene::kRadius).path.length();
    std::vector<std::size_t> order = {0, 1, 2, 3};
    double best = 1e9;
    do {  // one stop at a time in a fixed order is a tour of its own
      double length = 0.0;
      std::vector<Stop> ordered;
      for (const std::size_t i : order) {
        ordered.push_back(stops[i]);
      }
      // Greedy passes bound the optimum of this order from above.
      Pose2 at;
      for (const Stop& stop : ordered) {
        double least = 1e9;
        Pose2 out;
        for (const Pass& pass : stop) {
          const double cost =
              kTourRegion.ShortestInside(at, pass.in, scene::kRadius).length() + 1.0;
          if (cost < least) {
            least = cost;
            out = pass.out();
          }
        }
        length += least;
        at = out;
      }
      best = std::min(best, length);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_LE(found, 1.05 * best);
  }
}

TEST(PassTour, IsEmptyWithoutStops) {
  EXPECT_EQ(PlanPassTour({}, {}, kTourRegion, scene::kRadius).path.length(), 0.0);
}

TEST(UnseenPatches, FindTheStripBetweenTwoLanes) {
  SurveyGrid grid(scene::kArea);
  for (double north = -15.0; north <= 15.5; north += 1.5) {
    if (north != 0.0) {
      scene::Fly(grid, DubinsPath({north, -20.0, 0.5 * std::numbers::pi}, {{0.0, 40.0}}));
    }
  }
  scene::Fly(grid, DubinsPath({0.0, 4.0, 0.5 * std::numbers::pi}, {{0.0, 16.0}}));
  const Ground ground(grid, scene::TableFootprint());
  EXPECT_TRUE(UnseenPatches(ground, 4.0).empty());  // 3 m of overlap leave no strip
}

TEST(UnseenPatches, MeasureWhatIsMissing) {
  const SurveyGrid grid(scene::kArea);
  const Ground ground(grid, scene::TableFootprint());
  double area = 0.0;
  for (const Patch& patch : UnseenPatches(ground, 4.0)) {
    area += patch.missing_m2;
  }
  EXPECT_NEAR(area, 30.0 * 36.0, 1e-6);
}

TEST(UnseenPatches, PointAlongTheirLongAxis) {
  SurveyGrid grid(scene::kArea);
  for (double north = -15.0; north <= 15.5; north += 1.5) {
    if (north < -2.0 || north > 2.0) {
      scene::Fly(grid, DubinsPath({north, -20.0, 0.5 * std::numbers::pi}, {{0.0, 40.0}}));
    }
  }
  const Ground ground(grid, scene::TableFootprint());
  const std::vector<Patch> patches = UnseenPatches(ground, 8.0);
  ASSERT_FALSE(patches.empty());
  EXPECT_NEAR(std::abs(std::sin(patches.front().axis_yaw)), 1.0, 0.1);  // east-west
  EXPECT_GT(patches.front().length, patches.front().width);
}

}  // namespace
}  // namespace limpet
