// SPDX-License-Identifier: MIT
#include "limpet/waypoints/ray_approach.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

/// Corners on an ellipse, and so convex.
ConvexPolygon AnyPolygon(Random& random) {
  std::vector<MapPoint> corners;
  const int count = 3 + static_cast<int>(random.Uniform(0.0, 6.0));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    corners.push_back({.x = 12.0 * std::cos(angle), .y = 5.0 * std::sin(angle)});
  }
  return *ConvexPolygon::Of(corners);
}

/// Metre by metre, with a centimetre between.
double Walked(const ConvexPolygon& polygon, const MapPoint& from, double bearing, double length) {
  double least = 1e9;
  for (double along = 0.0; along <= length; along += 0.01) {
    least = std::min(
        least,
        std::max(0.0, polygon.Outside(Project(from, {.bearing = bearing, .distance = along}))));
  }
  return least;
}

TEST(RayApproach, IsWhatAWalkAlongTheWayFinds) {
  Random random(1, "rays");
  for (int run = 0; run < 200; ++run) {
    const ConvexPolygon polygon = AnyPolygon(random);
    const MapPoint from{.x = random.Uniform(-40.0, 40.0), .y = random.Uniform(-40.0, 40.0)};
    if (polygon.Contains(from)) continue;
    const double bearing = random.Uniform(-3.1, 3.1), length = random.Uniform(0.0, 60.0);
    const RayApproach approach(polygon, from, bearing);
    EXPECT_NEAR(approach.Within(length), Walked(polygon, from, bearing, length), 0.011);
    EXPECT_NEAR(approach.distance(), Walked(polygon, from, bearing, 120.0), 0.011);
  }
}

TEST(RayApproach, IsZeroOnAWayThatMeetsTheObstacle) {
  const ConvexPolygon square = *ConvexPolygon::Of({{10, -5}, {20, -5}, {20, 5}, {10, 5}});
  const RayApproach east(square, {0.0, 0.0}, 0.5 * std::numbers::pi);
  EXPECT_EQ(east.distance(), 0.0);
  EXPECT_NEAR(east.Within(7.0), 3.0, 1e-9) << "as far as that";
}

TEST(BufferedCorners, LieAtTheirDistanceAllRound) {
  Random random(2, "buffers");
  for (int run = 0; run < 50; ++run) {
    const ConvexPolygon polygon = AnyPolygon(random);
    const std::vector<MapPoint> ring = BufferedCorners(polygon, 8.0);
    for (const MapPoint& corner : ring) {
      EXPECT_NEAR(polygon.Outside(corner), 8.0, 1e-6);
    }
    EXPECT_TRUE(ConvexPolygon::Of(ring).has_value()) << "viewers refuse others";
  }
}

TEST(RayApproach, TheBorderIsMetFromOutsideAndFromInsideOrNotAtAll) {
  const auto square = ConvexPolygon::Of({{-10, -10}, {-10, 10}, {10, 10}, {10, -10}});
  constexpr double kEast = 0.5 * std::numbers::pi;
  EXPECT_NEAR(DistanceToBorder(*square, {.x = 4.0, .y = 0.0}, kEast).value(), 6.0, 1e-9);
  EXPECT_NEAR(DistanceToBorder(*square, {.x = -25.0, .y = 3.0}, kEast).value(), 15.0, 1e-9);
  EXPECT_FALSE(DistanceToBorder(*square, {.x = 25.0, .y = 3.0}, kEast)) << "it lies astern";
  EXPECT_FALSE(DistanceToBorder(*square, {.x = -25.0, .y = 12.0}, kEast)) << "it passes by";
}

}  // namespace
}  // namespace limpet
