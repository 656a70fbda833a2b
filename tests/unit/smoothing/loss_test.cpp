// SPDX-License-Identifier: MIT
#include "estimation/smoothing/loss.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(Loss, OfLeastSquaresIsHalfTheSquareWithoutAnyWeight) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double norm = random.Uniform(0.0, 100.0);
    EXPECT_NEAR(Loss::LeastSquares().Cost(norm), 0.5 * norm * norm, 1e-9);
    EXPECT_EQ(Loss::LeastSquares().SqrtWeight(norm), 1.0);
  }
}

TEST(HuberLoss, IsLeastSquaresInsideAndALineOutside) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double threshold = random.Uniform(0.5, 4.0);
    const Loss loss = Loss::Huber(threshold);
    const double inside = random.Uniform(0.0, 1.0) * threshold;
    EXPECT_NEAR(loss.Cost(inside), 0.5 * inside * inside, 1e-12);
    const double outside = threshold + random.Uniform(0.0, 50.0);
    EXPECT_NEAR(loss.Cost(outside + 1.0) - loss.Cost(outside), threshold, 1e-9);
  }
}

TEST(HuberLoss, HasNeitherStepNorKinkAtItsThreshold) {
  constexpr double kStep = 1e-6;
  for (const double threshold : {0.5, 1.345, 3.0}) {
    const Loss loss = Loss::Huber(threshold);
    EXPECT_NEAR(loss.Cost(threshold - kStep), loss.Cost(threshold + kStep), 1e-5);
    const double before = (loss.Cost(threshold) - loss.Cost(threshold - kStep)) / kStep;
    const double after = (loss.Cost(threshold + kStep) - loss.Cost(threshold)) / kStep;
    EXPECT_NEAR(before, after, 1e-4);
  }
}

TEST(HuberLoss, ItsWeightMakesTheSlopeThatOfTheCost) {
  // Reweighted least squares: the gradient of 0.5 w^2 r^2 with w held is w^2 r, which is to be that
  // of the cost.
  Random random(3);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Loss loss = Loss::Huber(random.Uniform(0.5, 4.0));
    const double norm = random.Uniform(0.01, 20.0);
    const double slope = (loss.Cost(norm + kStep) - loss.Cost(norm - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(std::pow(loss.SqrtWeight(norm), 2) * norm, slope, 1e-5);
  }
}

TEST(HuberLoss, NeverCostsMoreThanLeastSquaresAndNeverWeighsMoreThanOne) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Loss loss = Loss::Huber(random.Uniform(0.5, 4.0));
    const double norm = random.Uniform(0.0, 30.0);
    EXPECT_LE(loss.Cost(norm), Loss::LeastSquares().Cost(norm) + 1e-12);
    EXPECT_LE(loss.SqrtWeight(norm), 1.0);
    EXPECT_GE(loss.SqrtWeight(norm), loss.SqrtWeight(norm + 1.0));
  }
}

}  // namespace
}  // namespace limpet
