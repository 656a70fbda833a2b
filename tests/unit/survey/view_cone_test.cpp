// SPDX-License-Identifier: MIT
// Which ground a camera sees, and how high above it, against projecting point by point.
#include "limpet/survey/view_cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/detection_chance.hpp"

namespace limpet {
namespace {

Pose DrawPose(Random& random) {
  return {{random.Uniform(-5.0, 5.0), random.Uniform(-5.0, 5.0), 3.5},
          random.Uniform(-0.2, 0.2),
          random.Uniform(-0.2, 0.2),
          random.Uniform(-std::numbers::pi, std::numbers::pi)};
}

/// Whether the image shows a point, with `margin` pixels to spare.
bool IsShown(const CameraModel& camera, const Pose& X_WB, const Eigen::Vector3d& p_W,
             double margin) {
  const auto pixel = camera.Project(camera.InCamera(X_WB, p_W));
  return pixel && pixel->x() > margin && pixel->x() < camera.width_px - margin &&
         pixel->y() > margin && pixel->y() < camera.height_px - margin;
}

TEST(ViewCone, SeesTheGroundThatTheImageShows) {
  const CameraModel camera;
  Random random(1, "cone");
  int seen = 0;
  for (int run = 0; run < 2000; ++run) {
    const Pose X_WB = DrawPose(random);
    const ViewCone cone(X_WB, camera, 0.0);
    const Eigen::Vector3d p_W(X_WB.p_WB.x() + random.Uniform(-6.0, 6.0),
                              X_WB.p_WB.y() + random.Uniform(-6.0, 6.0), 7.5);
    const bool is_seen = cone.SeenHeight(p_W).has_value();
    seen += is_seen ? 1 : 0;
    if (IsShown(camera, X_WB, p_W, 1.0)) {
      EXPECT_TRUE(is_seen);
    } else if (!IsShown(camera, X_WB, p_W, -1.0)) {
      EXPECT_FALSE(is_seen);
    }
  }
  EXPECT_GT(seen, 300);
}

TEST(ViewCone, SeesUpToTheHeightWhereTheImageEnds) {
  const CameraModel camera;
  Random random(2, "cone");
  for (int run = 0; run < 1000; ++run) {
    const Pose X_WB = DrawPose(random);
    const ViewCone cone(X_WB, camera, 0.0);
    const Eigen::Vector3d p_W(X_WB.p_WB.x() + random.Uniform(-3.0, 3.0),
                              X_WB.p_WB.y() + random.Uniform(-3.0, 3.0), 7.5);
    const auto height = cone.SeenHeight(p_W);
    if (!height || *height > 3.5) continue;  // straight below nothing ends before the camera
    const Eigen::Vector3d up(0.0, 0.0, -1.0);
    EXPECT_TRUE(IsShown(camera, X_WB, p_W + 0.98 * *height * up, -0.5));
    EXPECT_FALSE(IsShown(camera, X_WB, p_W + (*height + 0.05) * up, 0.5)) << *height;
  }
}

TEST(ViewCone, SeesLessHighTheFurtherInsideAnObjectMustBe) {
  const CameraModel camera;
  Random random(3, "cone");
  for (int run = 0; run < 500; ++run) {
    const Pose X_WB = DrawPose(random);
    const Eigen::Vector3d p_W(X_WB.p_WB.x() + random.Uniform(-3.0, 3.0),
                              X_WB.p_WB.y() + random.Uniform(-3.0, 3.0), 7.5);
    const auto free = ViewCone(X_WB, camera, 0.0).SeenHeight(p_W);
    const auto inset = ViewCone(X_WB, camera, 0.3).SeenHeight(p_W);
    ASSERT_EQ(free.has_value(), inset.has_value()) << "the ground itself needs no room";
    if (!free) continue;
    EXPECT_LE(*inset, *free);
    EXPECT_GE(*inset, 0.0);
  }
}

TEST(ViewCone, NamesEveryCellThatItMaySee) {
  const CameraModel camera;
  const GridFrame frame{
      .north_min = -12.0, .east_min = -12.0, .cell_m = 0.5, .rows = 48, .columns = 48};
  Random random(4, "cells");
  for (int run = 0; run < 60; ++run) {
    const Pose X_WB = DrawPose(random);
    const CellBox box = ViewCone(X_WB, camera, 0.0).CellsBelow(frame, 7.5);
    for (int row = 0; row < frame.rows; ++row) {
      for (int column = 0; column < frame.columns; ++column) {
        const Eigen::Vector3d p_W(-12.0 + 0.5 * (row + 0.5), -12.0 + 0.5 * (column + 0.5), 7.5);
        const bool is_named = row >= box.row_min && row <= box.row_max &&
                              column >= box.column_min && column <= box.column_max;
        EXPECT_TRUE(is_named || !IsShown(camera, X_WB, p_W, 0.0));
      }
    }
    EXPECT_GE(box.row_min, 0);
    EXPECT_LT(box.row_max, frame.rows);
    EXPECT_LT((box.row_max - box.row_min + 1) * (box.column_max - box.column_min + 1), 1700)
        << "and not the whole grid";
  }
}

TEST(DetectionChanceProperties, IsAChanceThatFallsWithRangeAndGrowsWithTheShareShown) {
  Random random(5, "detects");
  for (int run = 0; run < 2000; ++run) {
    DetectionModel model;
    model.best = random.Uniform(0.1, 0.99);
    model.visibility = Meters(random.Uniform(2.0, 12.0));
    const double range = random.Uniform(0.0, 15.0), share = random.Uniform(0.0, 1.0);
    const double chance = DetectionChance(model, {.range = range, .share = share});
    EXPECT_GE(chance, 0.0);
    EXPECT_LE(chance, model.best + 1e-12);
    EXPECT_LE(DetectionChance(model, {.range = range + 0.5, .share = share}), chance + 1e-12);
    EXPECT_GE(DetectionChance(model, {.range = range, .share = std::min(1.0, share + 0.1)}),
              chance - 1e-12);
  }
}

TEST(VisibleShareProperties, ShrinksAsTheObjectLeavesTheImage) {
  const CameraModel camera;
  Random random(6, "share");
  for (int run = 0; run < 100; ++run) {
    const double bearing = random.Uniform(-3.1, 3.1), radius = random.Uniform(0.2, 0.8);
    double before = 1.0;
    for (double out = 0.0; out < 6.0; out += 0.1) {
      const Eigen::Vector3d p_W(out * std::cos(bearing), out * std::sin(bearing), 7.0);
      const double share = VisibleShare(camera, Pose{{0.0, 0.0, 3.5}, 0.0, 0.0, 0.0}, p_W, radius);
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, before + 0.03) << out;
      before = share;
    }
    EXPECT_EQ(before, 0.0);
  }
}

TEST(ViewCone, SaysHowFarInsideItsNearestEdgeAPlaceLies) {
  const CameraModel camera;
  const ViewCone cone({{0.0, 0.0, 3.5}, 0.0, 0.0, 0.0}, camera, 0.1);
  const double across = 4.0 * camera.half_across(), along = 4.0 * camera.half_along();
  EXPECT_NEAR(cone.Inside({0.0, across - 0.3, 7.5}, 0.0, false), 0.3, 1e-9);
  EXPECT_NEAR(cone.Inside({along + 0.2, 0.0, 7.5}, 0.0, false), -0.2, 1e-9);
  EXPECT_NEAR(cone.Inside({0.0, 0.5 * across - 0.3, 7.5}, 2.0, true), 0.2, 1e-9);
}

TEST(ViewCone, DrawnInShowsLessOnEverySide) {
  const CameraModel camera;
  ViewCone cone({{0.0, 0.0, 3.5}, 0.0, 0.0, 0.0}, camera, 0.0);
  cone.DrawIn(0.4);
  const double across = 4.0 * camera.half_across(), along = 4.0 * camera.half_along();
  EXPECT_TRUE(cone.SeenHeight({0.0, across - 0.41, 7.5}));
  EXPECT_FALSE(cone.SeenHeight({0.0, across - 0.39, 7.5}));
  EXPECT_TRUE(cone.SeenHeight({0.41 - along, 0.0, 7.5}));
  EXPECT_FALSE(cone.SeenHeight({0.39 - along, 0.0, 7.5}));
}

}  // namespace
}  // namespace limpet
