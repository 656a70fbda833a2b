// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_along.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/objective.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

using scene::kArea;

/// Layers of every cell, as a plain reading of the definition gives them.
std::vector<int> LevelsAfter(const Ground& ground, const DubinsPath& path) {
  const GridFrame& frame = ground.frame();
  std::vector<int> levels(ground.levels().begin(), ground.levels().end());
  const auto look = [&](const Pose2& at) {
    for (int row = 0; row < frame.rows; ++row) {
      for (int column = 0; column < frame.columns; ++column) {
        const double dn = frame.north_min + (row + 0.5) * frame.cell_m - at.north;
        const double de = frame.east_min + (column + 0.5) * frame.cell_m - at.east;
        const double ahead = dn * std::cos(at.yaw) + de * std::sin(at.yaw);
        const double starboard = -dn * std::sin(at.yaw) + de * std::cos(at.yaw);
        int& level = levels[static_cast<std::size_t>(row * frame.columns + column)];
        for (int layer = level; layer < Footprint::kLayers; ++layer) {
          if (std::abs(ahead) <= ground.footprint().half_along(layer) &&
              std::abs(starboard) <= ground.footprint().half_across(layer)) {
            level = layer + 1;
          }
        }
      }
    }
  };
  Pose2 from = path.start();
  for (const PathSegment& segment : path.segments()) {
    for (double s = SeenWorkspace::kStep; s < segment.length - 1e-9; s += SeenWorkspace::kStep) {
      look(Advance(from, {.curvature = segment.curvature, .length = s}));
    }
    from = Advance(from, segment);
    look(from);
  }
  return levels;
}

double Area(const std::vector<int>& levels, const GridFrame& frame) {
  double sum = 0.0;
  for (const int level : levels) {
    sum += level;
  }
  return sum * frame.cell_m * frame.cell_m / Footprint::kLayers;
}

double Border(const std::vector<int>& levels, const GridFrame& frame) {
  const auto level = [&](int row, int column) {
    const bool is_inside = row >= 0 && row < frame.rows && column >= 0 && column < frame.columns;
    return is_inside ? levels[static_cast<std::size_t>(row * frame.columns + column)]
                     : Footprint::kLayers;
  };
  double edges = 0.0;
  for (int row = 0; row <= frame.rows; ++row) {
    for (int column = 0; column <= frame.columns; ++column) {
      edges += std::abs(level(row, column) - level(row - 1, column));
      edges += std::abs(level(row, column) - level(row, column - 1));
    }
  }
  return edges * frame.cell_m / Footprint::kLayers;
}

class SeenAlongPaths : public ::testing::Test {
 protected:
  DubinsPath RandomPath() {
    DubinsPath path(
        {random_.Uniform(-15.0, 15.0), random_.Uniform(-18.0, 18.0), random_.Uniform(-3.0, 3.0)});
    for (int i = 0; i < 4; ++i) {
      path.Append({.curvature = random_.Uniform(-1.0 / 3.0, 1.0 / 3.0),
                   .length = random_.Uniform(0.5, 4.0)});
    }
    return path;
  }
  Random random_{1};
};

TEST_F(SeenAlongPaths, NewAreaAndFrontierEqualBruteForce) {
  SurveyGrid grid(kArea);
  for (int i = 0; i < 20; ++i) {
    scene::Fly(grid, RandomPath());
    constexpr LayerWeights kUniformLayers = {0.25, 0.25, 0.25, 0.25};
    const Ground ground(grid, scene::TableFootprint(), kUniformLayers);
    SeenAlong seen(ground);
    const DubinsPath path = RandomPath();
    const NewlySeen gain = seen(path);
    const std::vector<int> before(ground.levels().begin(), ground.levels().end());
    const std::vector<int> after = LevelsAfter(ground, path);
    ASSERT_NEAR(gain.new_area, Area(after, ground.frame()) - Area(before, ground.frame()), 1e-6);
    ASSERT_NEAR(gain.frontier_growth,
                Border(after, ground.frame()) - Border(before, ground.frame()), 1e-6);
  }
}

TEST_F(SeenAlongPaths, IsTheSameWhenAskedAgain) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  SeenAlong seen(ground);
  const DubinsPath path = RandomPath();
  const NewlySeen first = seen(path);
  static_cast<void>(seen(RandomPath()));
  EXPECT_EQ(seen(path).new_area, first.new_area);
}

TEST_F(SeenAlongPaths, FollowsTheGroundsUpdates) {
  SurveyGrid grid(kArea);
  Ground ground(grid, scene::TableFootprint());
  SeenAlong seen(ground);
  const DubinsPath path({0.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 10.0}});
  EXPECT_GT(seen(path).new_area, 30.0);
  scene::Fly(grid, path);
  ground.Update(grid);
  EXPECT_LT(seen(path).new_area, 1.0);
}

TEST(SeenAlong, ASweptLineShowsItsSwath) {
  SurveyGrid grid(SurveyArea{-15.0, 15.0, -18.0, 18.0, 2.0, 0.0});  // the bottom alone
  const Ground ground(grid, Footprint({.altitude = 4.0}, CameraModel{}));
  SeenAlong seen(ground);
  const NewlySeen gain = seen(DubinsPath({-5.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 10.0}}));
  EXPECT_NEAR(gain.new_area, 6.713 * (9.5 + 4.619), 5.0);
  EXPECT_NEAR(gain.frontier_growth, 2.0 * (6.713 + 9.5 + 4.619), 2.0);
}

TEST(SeenAlong, LanesBesideSeenGroundLeaveLessFrontierThanLanesApart) {
  SurveyGrid grid(kArea);
  scene::Fly(grid, DubinsPath({-10.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 20.0}}));
  const Ground ground(grid, scene::TableFootprint());
  SeenAlong seen(ground);
  const auto lane = [](double east) {
    return DubinsPath({-10.0, east, 0.0}, {{.curvature = 0.0, .length = 20.0}});
  };
  EXPECT_LT(seen(lane(4.0)).frontier_growth, seen(lane(9.0)).frontier_growth - 20.0);
}

TEST(SeenWorkspace, RewindRestoresEverything) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  SeenWorkspace workspace(ground);
  const PathSegment motion{.curvature = 0.2, .length = 5.0};
  const NewlySeen first = workspace.Sweep({0.0, 0.0, 1.0}, motion);
  workspace.Rewind(0);
  const NewlySeen again = workspace.Sweep({0.0, 0.0, 1.0}, motion);
  EXPECT_EQ(first.new_area, again.new_area);
  EXPECT_EQ(first.frontier_growth, again.frontier_growth);
}

TEST(SeenWorkspace, ASecondPassShowsNothingNew) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  SeenWorkspace workspace(ground);
  const PathSegment motion{.curvature = 0.2, .length = 5.0};
  static_cast<void>(workspace.Sweep({0.0, 0.0, 1.0}, motion));
  EXPECT_EQ(workspace.Sweep({0.0, 0.0, 1.0}, motion).new_area, 0.0);
}

TEST(Ground, CountsTheLayersThatAHeightReaches) {
  SurveyGrid grid(kArea);
  grid.Observe(scene::At({0.0, 0.0, 0.0}), scene::kAltitude, CameraModel{});
  const Ground ground(grid, scene::TableFootprint());
  const auto level = [&](double north, double east) {
    const int row = static_cast<int>((north + 15.0) / 0.25);
    const int column = static_cast<int>((east + 18.0) / 0.25);
    return static_cast<int>(ground.levels()[static_cast<std::size_t>(row * 144 + column)]);
  };
  EXPECT_EQ(level(0.1, 0.1), 4);
  EXPECT_EQ(level(0.1, 3.1), 1);
  EXPECT_EQ(level(0.1, 5.0), 0);
}

TEST(Ground, AFullSwathOfNewGroundIsWorthItsLength) {
  const SurveyGrid grid(kArea);
  const Ground ground(grid, scene::TableFootprint());
  SeenAlong seen(ground);
  const double short_way =
      seen(DubinsPath({-10.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 5.0}})).new_area;
  const double long_way =
      seen(DubinsPath({-10.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 15.0}})).new_area;
  EXPECT_NEAR((long_way - short_way) / ground.swath(), 10.0, 0.5);
}

TEST(Objective, ATargetIsWorthLessTheLaterItIsPassed) {
  Objective objective;
  objective.target_decay_m = 100.0;
  objective.targets = {{.north = 20.0, .east = 0.0, .window = {1.5, 1.5}, .value = 50.0}};
  const DubinsPath path({0.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 30.0}});
  EXPECT_NEAR(TargetValueOf(path, objective), 50.0 * (1.0 - 0.185), 0.2);
}

TEST(Objective, ATargetThatIsNotPassedIsWorthNothing) {
  Objective objective;
  objective.targets = {{.north = 20.0, .east = 5.0, .window = {1.5, 1.5}, .value = 50.0}};
  const DubinsPath path({0.0, 0.0, 0.0}, {{.curvature = 0.0, .length = 30.0}});
  EXPECT_EQ(TargetValueOf(path, objective), 0.0);
}

}  // namespace
}  // namespace limpet
