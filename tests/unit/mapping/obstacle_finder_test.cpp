// SPDX-License-Identifier: MIT
#include "estimation/mapping/obstacle_finder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "estimation/mapping/obstacle_outline.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using Eigen::Vector2d;

struct Pile {
  Vector2d center_W;
  double radius;
};

/// Columns over a bottom that rises northwards, and how the vehicle that looks at them lies.
struct Waters {
  double slope = 0.0;  ///< the bottom rises so much per metre north
  double depth = 8.0, down = 4.0, pitch = 0.0;
  std::vector<Pile> piles{};
};

class Harbour : public Waters {
 public:
  explicit Harbour(Waters waters) : Waters(std::move(waters)) {}

  /// Looks from there, `yaw` clockwise from north.
  void LookFrom(const Vector2d& at_W, double yaw) {
    t_ += 0.25;
    const double bottom = depth - slope * at_W.x();
    finder.AddBeams(t_, Beams(at_W, yaw, bottom));
    finder.AddSonar(t_, {.north = at_W.x(),
                         .east = at_W.y(),
                         .down = down,
                         .pitch = pitch,
                         .yaw = yaw,
                         .ping = Ping(at_W, yaw, bottom)});
  }

  ObstacleFinder finder;

 private:
  [[nodiscard]] PosedBeams Beams(const Vector2d& at_W, double yaw, double bottom) const {
    PosedBeams beams;
    beams.north = at_W.x(), beams.east = at_W.y(), beams.down = down, beams.yaw = yaw;
    const auto range = [&](std::size_t beam) {
      const Eigen::Vector3d way = RotationOf(beams.pose()) * BeamDirections({})[beam];
      return (bottom - down) / (way.z() + slope * way.x());
    };
    beams.b1 = range(0), beams.b2 = range(1), beams.b3 = range(2), beams.b4 = range(3);
    return beams;
  }
  [[nodiscard]] SonarPing Ping(const Vector2d& at_W, double yaw, double bottom) const {
    SonarPing ping{.first = -1.0, .step = 2.0 / 60.0, .reach = 15.0, .ranges = {}};
    for (int beam = 0; beam <= 60; ++beam) {
      const double bearing = yaw + ping.first + beam * ping.step;
      const Vector2d way(std::cos(bearing), std::sin(bearing));
      double first = ToBottom(bottom, way);
      for (const Pile& pile : piles) {
        const double along = (pile.center_W - at_W).dot(way);
        const double aside_sq = (pile.center_W - at_W).squaredNorm() - along * along;
        const double half_sq = pile.radius * pile.radius - aside_sq;
        if (along > 0.0 && half_sq > 0.0) first = std::min(first, along - std::sqrt(half_sq));
      }
      ping.ranges.push_back(first <= ping.reach ? first : 0.0);
    }
    return ping;
  }
  [[nodiscard]] double ToBottom(double bottom, const Vector2d& way) const {
    const double closing = -std::sin(pitch) + slope * way.x();
    return closing > 0.0 ? (bottom - down) / closing : 1e9;
  }
  double t_ = 0.0;
};

Vector2d MeanOf(const Obstacle& obstacle) {
  Vector2d mean = Vector2d::Zero();
  for (const auto& [north, east] : obstacle.outline) {
    mean += Vector2d(north, east) / static_cast<double>(obstacle.outline.size());
  }
  return mean;
}

TEST(ObstacleFinder, FindsTheSideOfAPileThatItSees) {
  Harbour harbour({.piles = {{{10.0, 2.0}, 0.5}}});
  for (int i = 0; i < 8; ++i)
    harbour.LookFrom({0.1 * i, 0.0}, 0.0);
  ASSERT_TRUE(harbour.finder.Update());
  ASSERT_EQ(harbour.finder.obstacles().size(), 1U);
  EXPECT_LT((MeanOf(harbour.finder.obstacles()[0]) - Vector2d(9.6, 2.0)).norm(), 0.3);
}

TEST(ObstacleFinder, OneStrayEchoIsNoObstacle) {
  Harbour harbour({.piles = {{{10.0, 2.0}, 0.5}}});
  harbour.LookFrom({0.0, 0.0}, 0.0);
  EXPECT_FALSE(harbour.finder.Update());
  harbour.piles.clear();
  for (int i = 0; i < 40; ++i)
    harbour.LookFrom({0.0, 0.0}, 0.0);
  EXPECT_FALSE(harbour.finder.Update());
  EXPECT_TRUE(harbour.finder.cells().is_empty());
}

TEST(ObstacleFinder, ABottomThatRisesIsNoneHoweverFarItIsHeard) {
  Harbour harbour({.slope = 0.25, .depth = 6.5});
  for (int i = 0; i < 20; ++i) {
    harbour.down = 4.0 - 0.25 * 0.1 * i;
    harbour.LookFrom({0.1 * i, 0.0}, 0.0);
  }
  EXPECT_FALSE(harbour.finder.Update());
}

TEST(ObstacleFinder, ANoseThatPointsDownMakesNoObstacleOfTheBottom) {
  Harbour harbour({.pitch = -0.5});
  for (int i = 0; i < 20; ++i)
    harbour.LookFrom({0.1 * i, 0.0}, 0.0);
  EXPECT_FALSE(harbour.finder.Update());
}

TEST(ObstacleFinder, WhatHasGoneIsForgottenOnceBeamsPassThere) {
  Harbour harbour({.piles = {{{8.0, 0.0}, 0.5}}});
  for (int i = 0; i < 10; ++i)
    harbour.LookFrom({0.0, 0.0}, 0.0);
  ASSERT_TRUE(harbour.finder.Update());
  harbour.piles.clear();
  for (int i = 0; i < 60; ++i)
    harbour.LookFrom({0.02 * i, 0.01 * i}, 0.002 * i);
  EXPECT_TRUE(harbour.finder.Update());
  EXPECT_TRUE(harbour.finder.obstacles().empty());
}

TEST(ObstacleFinder, ForgetsNothingThatItsBeamsPassAbove) {
  Harbour harbour({.piles = {{{8.0, 0.0}, 0.5}}});
  for (int i = 0; i < 10; ++i)
    harbour.LookFrom({0.0, 0.0}, 0.0);
  ASSERT_TRUE(harbour.finder.Update());
  harbour.piles.clear();
  harbour.down = 1.0;  // its beams pass above
  for (int i = 0; i < 60; ++i)
    harbour.LookFrom({0.02 * i, 0.0}, 0.0);
  static_cast<void>(harbour.finder.Update());
  EXPECT_EQ(harbour.finder.obstacles().size(), 1U);
}

TEST(ObstacleFinder, ToldOnceNotAtEveryPing) {
  Harbour harbour({.piles = {{{10.0, 2.0}, 0.5}, {{9.0, -6.0}, 0.4}}});
  int news = 0;
  for (int i = 0; i < 60; ++i) {
    harbour.LookFrom({0.05 * i, 0.0}, 0.0);
    news += harbour.finder.Update() ? 1 : 0;
  }
  EXPECT_EQ(harbour.finder.obstacles().size(), 2U);
  EXPECT_LE(news, 8);
}

TEST(ObstacleFinder, GoesWithTheTrackWhenThatMoves) {
  Harbour harbour({.piles = {{{10.0, 2.0}, 0.5}}});
  for (int i = 0; i < 8; ++i)
    harbour.LookFrom({0.1 * i, 0.0}, 0.0);
  ASSERT_TRUE(harbour.finder.Update());
  const Vector2d before = MeanOf(harbour.finder.obstacles()[0]);
  const int id = harbour.finder.obstacles()[0].id;
  harbour.finder.Shift({.steps = {{0.0, 1.0, -0.5, 0.0, 0.0}, {100.0, 1.0, -0.5, 0.0, 0.0}}});
  ASSERT_TRUE(harbour.finder.Update());
  ASSERT_EQ(harbour.finder.obstacles().size(), 1U);
  EXPECT_EQ(harbour.finder.obstacles()[0].id, id);
  EXPECT_LT((MeanOf(harbour.finder.obstacles()[0]) - before - Vector2d(1.0, -0.5)).norm(), 0.15);
}

TEST(ObstacleOutline, HoldsEveryEchoAndIsConvex) {
  Random random(5);
  for (int run = 0; run < 200; ++run) {
    std::vector<EchoCells::Cell> group(static_cast<std::size_t>(1 + run % 9));
    for (EchoCells::Cell& cell : group)
      cell.p_W = {random.Uniform(-3, 3), random.Uniform(-3, 3), 4.0};
    const auto outline = OutlineOf(group, 0.125);
    ASSERT_GE(outline.size(), 4U);
    for (const EchoCells::Cell& cell : group) {
      EXPECT_EQ(Outside(outline, cell.p_W.head<2>()), 0.0);
    }
    EXPECT_GT(Outside(outline, {4.0, 0.0}), 0.8);
  }
}

TEST(ObstacleOutline, AWallThatBendsIsSeveral) {
  std::vector<EchoCells::Cell> wall;
  for (int i = 0; i < 40; ++i)
    wall.push_back({.p_W = {0.1, 0.25 * i + 0.1, 4.0}});
  for (int i = 1; i < 40; ++i)
    wall.push_back({.p_W = {0.25 * i + 0.1, 0.1, 4.0}});
  const auto groups = GroupsOf(wall, 0.25);
  EXPECT_GE(groups.size(), 5U);
  for (const auto& group : groups) {
    EXPECT_GT(Outside(OutlineOf(group, 0.125), {5.0, 5.0}), 0.0);  // the water between its arms
  }
}

}  // namespace
}  // namespace limpet
