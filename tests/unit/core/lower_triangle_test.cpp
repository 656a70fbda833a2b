// SPDX-License-Identifier: MIT
#include "limpet/core/lower_triangle.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LowerTriangle, BringsASymmetricMatrixBack) {
  Eigen::Matrix3d matrix;
  matrix << 4.0, 1.0, 0.5, 1.0, 3.0, 0.2, 0.5, 0.2, 2.0;
  EXPECT_THAT(LowerTriangleOf(matrix), ::testing::ElementsAre(4.0, 1.0, 3.0, 0.5, 0.2, 2.0));
  EXPECT_EQ(*FromLowerTriangle(LowerTriangleOf(matrix)), matrix);
}

TEST(LowerTriangle, RefusesNumbersThatMakeNoTriangle) {
  EXPECT_FALSE(FromLowerTriangle({1.0, 2.0}));
  EXPECT_FALSE(FromLowerTriangle({std::numeric_limits<double>::quiet_NaN()}));
}

TEST(LowerTriangle, OfNothingIsNothing) { EXPECT_EQ(FromLowerTriangle({})->rows(), 0); }

}  // namespace
}  // namespace limpet
