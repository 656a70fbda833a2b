// SPDX-License-Identifier: MIT
#include "limpet/core/cross_product.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Eigen::Vector3d DrawVector(Random& random) {
  return {random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0)};
}

TEST(CrossOf, IsPositiveFromTheFirstAxisToTheSecond) {
  EXPECT_EQ(CrossOf({1.0, 0.0}, {0.0, 1.0}), 1.0) << "east lies to starboard of north";
  EXPECT_EQ(CrossOf({0.0, 1.0}, {1.0, 0.0}), -1.0);
  EXPECT_EQ(CrossOf({2.0, 3.0}, {5.0, 7.0}), -1.0);
  EXPECT_EQ(CrossOf({2.0, 3.0}, {-4.0, -6.0}), 0.0) << "along one line";
}

TEST(CrossOf, IsTheDownComponentInSpace) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d a = DrawVector(random), b = DrawVector(random);
    EXPECT_NEAR(CrossOf(a.head<2>(), b.head<2>()), a.cross(b).z(), 1e-14);
  }
}

TEST(CrossMatrixOf, TakesTheCrossProductAndIsSkew) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d v = DrawVector(random), u = DrawVector(random);
    EXPECT_LT((CrossMatrixOf(v) * u - v.cross(u)).norm(), 1e-14);
    EXPECT_EQ(CrossMatrixOf(v).transpose(), -CrossMatrixOf(v));
  }
}

}  // namespace
}  // namespace limpet
