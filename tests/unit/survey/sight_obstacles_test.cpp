// SPDX-License-Identifier: MIT
#include "limpet/survey/sight_obstacles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// A pile of half a metre's half width that reaches up to 2 m below the surface.
Obstacle PileAt(double north, double east, double half = 0.5) {
  return {.id = 1,
          .outline = {{north - half, east - half},
                      {north - half, east + half},
                      {north + half, east + half},
                      {north + half, east - half}},
          .top = 2.0};
}

const Eigen::Vector3d kEye(0.0, 0.0, 3.5);

TEST(SightObstacles, HideWhatIsBehindThemAndNothingElse) {
  const SightObstacles pile({PileAt(2.0, 0.0)});
  EXPECT_TRUE(pile.Hide(kEye, {4.0, 0.0, 7.5}));
  EXPECT_TRUE(pile.Hide(kEye, {4.0, 1.2, 7.5}));
  EXPECT_FALSE(pile.Hide(kEye, {4.0, 1.4, 7.5})) << "beside its shadow";
  EXPECT_FALSE(pile.Hide(kEye, {1.2, 0.0, 7.5})) << "before it";
  EXPECT_FALSE(pile.Hide(kEye, {-4.0, 0.0, 7.5})) << "on the other side";
  EXPECT_FALSE(SightObstacles().Hide(kEye, {4.0, 0.0, 7.5}));
}

TEST(SightObstacles, AreSeenOverFromAbove) {
  const SightObstacles pile({PileAt(2.0, 0.0)});
  EXPECT_FALSE(pile.Hide({0.0, 0.0, 0.5}, {10.0, 0.0, 4.0}));
  EXPECT_TRUE(pile.Hide({0.0, 0.0, 0.5}, {3.0, 0.0, 4.0}));
}

TEST(SightObstacles, OneThatHoldsTheCameraOrIsOutOfReachCastsNoShadow) {
  const SightObstacles pile({PileAt(0.0, 0.2), PileAt(9.0, 0.0)});
  EXPECT_TRUE(pile.From(kEye, 6.0).empty());
  EXPECT_FALSE(pile.From(kEye, 9.0).empty());
}

/// Whether a segment meets a square, by going along it.
bool Meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& middle,
           double half) {
  for (int i = 0; i <= 2000; ++i) {
    const Eigen::Vector2d at = from + (to - from) * (i / 2000.0);
    if ((at - middle).cwiseAbs().maxCoeff() <= half) return true;
  }
  return false;
}

TEST(SightObstacles, AgreeWithTheLineOfSightWhereverTheyStand) {
  Random random(7);
  int hidden = 0;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector2d middle(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0));
    if (middle.cwiseAbs().maxCoeff() < 0.8) continue;
    const Eigen::Vector3d place(random.Uniform(-6.0, 6.0), random.Uniform(-6.0, 6.0), 7.5);
    const Eigen::Vector2d off = place.head<2>() - middle;
    if (off.cwiseAbs().maxCoeff() < 0.55) continue;  // what it stands on is not asked for
    const bool is_hidden = SightObstacles({PileAt(middle.x(), middle.y())}).Hide(kEye, place);
    const bool is_clear = !Meets(kEye.head<2>(), place.head<2>(), middle, 0.51);
    const bool is_met = Meets(kEye.head<2>(), place.head<2>(), middle, 0.49);
    if (is_clear) {
      EXPECT_FALSE(is_hidden) << middle.transpose() << "; " << place.transpose();
    }
    if (is_met) {
      EXPECT_TRUE(is_hidden) << middle.transpose() << "; " << place.transpose();
    }
    hidden += is_hidden ? 1 : 0;
  }
  EXPECT_GT(hidden, 20);
}

}  // namespace
}  // namespace limpet
