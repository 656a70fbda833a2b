// SPDX-License-Identifier: MIT
#include "limpet/vision/corner_grid.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

CameraModel SmallCamera() {
  CameraModel camera;
  camera.width_px = 20;
  camera.height_px = 17;
  return camera;
}

TEST(CornerGrid, ReachesOverAllPixelsOfAnImageThatEndsWithinABlock) {
  const CornerGrid grid(SmallCamera(), 1);
  EXPECT_EQ(grid.columns(), 4U);
  EXPECT_EQ(grid.rows(), 4U);
}

TEST(CornerGrid, ARowIsTakenAtTheMiddleOfItsPixels) {
  CornerGrid grid(SmallCamera(), 2);
  grid.EachCorner([&grid](int column, int row, double&) {
    grid.node(1, column, row) = static_cast<float>(CornerGrid::kBlock * row + column);
  });
  for (const int row : {0, 7, 8, 16}) {
    grid.TakeRow(row);
    EXPECT_FLOAT_EQ(grid.at_row(1)[0], static_cast<float>(row) + 0.5F);
    EXPECT_FLOAT_EQ(grid.at_row(1)[2], static_cast<float>(row) + 2.5F);
  }
}

TEST(CornerGrid, StepsGoFromTheMiddleOfTheFirstPixelToThatOfTheLast) {
  CornerGrid grid(SmallCamera(), 2);
  grid.EachCorner([&grid](int column, int row, double&) {
    grid.node(0, column, row) = 800.0F * static_cast<float>(column);
    grid.node(1, column, row) = -160.0F * static_cast<float>(column);
  });
  grid.TakeRow(3);
  const CornerGrid::Steps steps = grid.StepsIn(1, grid.at_row(0), grid.at_row(1));
  EXPECT_EQ(steps.u, 850);
  EXPECT_EQ(steps.step_u, 100);
  EXPECT_EQ(steps.v, -170);
  EXPECT_EQ(steps.step_v, -20);
  EXPECT_EQ(grid.StepsIn(1, grid.at_row(0), grid.at_row(1), 16.0F).step_u, 1600);
}

TEST(CornerGrid, AShadowDimsThreeLayersWhereItFallsAndNothingElse) {
  CornerGrid grid(SmallCamera(), 5);
  grid.EachCorner([&grid](int column, int row, double&) {
    grid.place(column, row) = Eigen::Vector2f(static_cast<float>(row), static_cast<float>(column));
    for (int layer = 0; layer < 5; ++layer)
      grid.node(layer, column, row) = 1.0F;
  });
  grid.Dim(1, {2.0F, 1.0F}, [](float distance2) { return distance2 < 0.5F ? 0.25F : 1.0F; });
  EXPECT_EQ(grid.node(0, 1, 2), 1.0F);
  EXPECT_EQ(grid.node(1, 1, 2), 0.25F);
  EXPECT_EQ(grid.node(3, 1, 2), 0.25F);
  EXPECT_EQ(grid.node(4, 1, 2), 1.0F);
  EXPECT_EQ(grid.node(2, 2, 2), 1.0F);
}

}  // namespace
}  // namespace limpet
