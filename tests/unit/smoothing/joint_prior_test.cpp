// SPDX-License-Identifier: MIT
#include "estimation/smoothing/joint_prior.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

class JointPriorProperties : public ::testing::TestWithParam<int> {
 protected:
  static Eigen::MatrixXd DrawSpread(Random& random, Eigen::Index n) {
    Eigen::MatrixXd root(n, n);
    for (Eigen::Index i = 0; i < n * n; ++i)
      root(i) = random.Normal(1.0);
    return root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
  }
  [[nodiscard]] Eigen::VectorXd DrawVector(Eigen::Index n) {
    Eigen::VectorXd v(n);
    for (Eigen::Index i = 0; i < n; ++i)
      v(i) = random_.Normal(5.0);
    return v;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "joint prior"};
  const Eigen::VectorXd mean_ = DrawVector(12);
  const Eigen::MatrixXd covariance_ = DrawSpread(random_, 12);
  const JointPrior prior_{{4, 9, 2, 7}, mean_, covariance_};
};

TEST_P(JointPriorProperties, CostsNothingAtItsMeanAndElseHalfTheSquaredDistance) {
  EXPECT_NEAR(prior_.Cost(mean_), 0.0, 1e-12);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd off = DrawVector(12);
    EXPECT_NEAR(prior_.Cost(mean_ + off), 0.5 * off.dot(covariance_.inverse() * off),
                1e-6 * (1.0 + prior_.Cost(mean_ + off)));
    EXPECT_GT(prior_.Cost(mean_ + off), 0.0);
  }
}

TEST_P(JointPriorProperties, WithoutALandmarkIsTheMarginalOfTheOthers) {
  const JointPrior less = prior_.Without(9);
  EXPECT_EQ(less.slots(), (std::vector{4, 2, 7}));
  Eigen::VectorXd rest(9);
  rest << mean_.segment<3>(0), mean_.segment<6>(6);
  EXPECT_TRUE(less.mean().isApprox(rest));
  // Its least cost over the place of the landmark that went is what is left.
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd others = rest + 0.3 * DrawVector(9);
    Eigen::VectorXd all(12);
    all << others.segment<3>(0), mean_.segment<3>(3), others.segment<6>(3);
    const Eigen::Matrix3d H = prior_.information().block<3, 3>(3, 3);
    const Eigen::Vector3d g = (prior_.information() * (all - mean_)).segment<3>(3);
    all.segment<3>(3) -= H.inverse() * g;
    EXPECT_NEAR(less.Cost(others), prior_.Cost(all), 1e-6 * (1.0 + less.Cost(others)));
  }
}

TEST_P(JointPriorProperties, ForgetsInAnyOrderTheSame) {
  const JointPrior forth = prior_.Without(4).Without(7), back = prior_.Without(7).Without(4);
  EXPECT_EQ(forth.slots(), back.slots());
  EXPECT_TRUE(forth.information().isApprox(back.information(), 1e-9));
  EXPECT_TRUE(prior_.Without(1234).information().isApprox(prior_.information(), 1e-9))
      << "nobody asked about that one";
}

INSTANTIATE_TEST_SUITE_P(Drawn, JointPriorProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
