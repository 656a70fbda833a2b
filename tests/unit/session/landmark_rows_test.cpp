// SPDX-License-Identifier: MIT
#include "limpet/session/landmark_rows.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

LandmarkCovariance ThreeLandmarks() {
  LandmarkCovariance joint{.ids = {4, 7, 9}, .cov_W = Eigen::MatrixXd(9, 9)};
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 9; ++column)
      joint.cov_W(row, column) = 10.0 * row + column;
  }
  return joint;
}

TEST(LandmarkRowsTest, TheOrderIsThatOfWhoAsks) {
  const auto covariance = CovarianceOf({9, 4}, ThreeLandmarks());
  ASSERT_TRUE(covariance.has_value());
  ASSERT_EQ(covariance->rows(), 6);
  EXPECT_EQ((*covariance)(0, 0), 66.0);
  EXPECT_EQ((*covariance)(3, 0), 6.0);
  EXPECT_EQ((*covariance)(1, 5), 72.0);
}

TEST(LandmarkRowsTest, ALandmarkThatWasNotKeptLeavesNoCovariance) {
  EXPECT_FALSE(CovarianceOf({4, 5}, ThreeLandmarks()).has_value());
}

}  // namespace
}  // namespace limpet
