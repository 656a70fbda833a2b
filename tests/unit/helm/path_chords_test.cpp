// SPDX-License-Identifier: MIT
#include "limpet/helm/path_chords.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(PathChords, FollowsAnArcToTwoCentimetres) {
  const double radius = 3.0;
  const DubinsPath turn({}, {{.curvature = 1.0 / radius, .length = std::numbers::pi * radius}});
  const std::vector<MapPoint> points = MapPointsOf(turn, 0.02);
  EXPECT_LT(points.size(), 20U);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double x = 0.5 * (points[i].x + points[i - 1].x) - radius;
    const double y = 0.5 * (points[i].y + points[i - 1].y);
    EXPECT_NEAR(std::hypot(x, y), radius, 0.021);
  }
  EXPECT_NEAR(points.back().x, 2.0 * radius, 1e-9);
}

}  // namespace
}  // namespace limpet
