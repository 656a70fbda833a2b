// SPDX-License-Identifier: MIT
#include "limpet/tuning/gaussian_process.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

Eigen::VectorXd One(double x) { return Eigen::VectorXd::Constant(1, x); }

ProcessShape Shape(double length, double signal) {
  return {.length = One(length), .signal = signal};
}

TEST(GaussianProcess, HasMaternsKernel) {
  const ProcessShape shape = Shape(0.5, 2.0);
  EXPECT_DOUBLE_EQ(shape.Kernel(One(0.3), One(0.3)), 4.0);
  const double s = std::sqrt(5.0) * 0.2 / 0.5;
  EXPECT_NEAR(shape.Kernel(One(0.1), One(0.3)), 4.0 * (1.0 + s + s * s / 3.0) * std::exp(-s),
              1e-12);
}

TEST(GaussianProcess, OfOneSampleGoesBackToItsMeanWithTheSignalsSpread) {
  const GaussianProcess process({{.x = One(0.5), .y = 3.0, .variance = 0.0}}, Shape(0.1, 2.0));
  EXPECT_NEAR(process.mean(), 3.0, 1e-9);
  EXPECT_NEAR(process.At(One(0.5)).sd, 0.0, 1e-3);
  EXPECT_NEAR(process.At(One(100.0)).sd, 2.0, 1e-9);
}

TEST(GaussianProcess, OfTwoNoisySamplesAgreesWithTheClosedForm) {
  // K = [[s + v, k], [k, s + v]]: by symmetry the mean is the average, and the weights are
  // +-(y1 - y2) / 2 / (s + v - k).
  const ProcessShape shape = Shape(0.4, 1.5);
  const double variance = 0.3, s = 2.25 * (1.0 + 1e-8), k = shape.Kernel(One(0.2), One(0.8));
  const GaussianProcess process({{.x = One(0.2), .y = 1.0, .variance = variance},
                                 {.x = One(0.8), .y = 5.0, .variance = variance}},
                                shape);
  EXPECT_NEAR(process.mean(), 3.0, 1e-9);
  const double weight = 2.0 / (s + variance - k);
  const Eigen::VectorXd at = One(0.3);
  const double k1 = shape.Kernel(at, One(0.2)), k2 = shape.Kernel(at, One(0.8));
  EXPECT_NEAR(process.At(at).mean, 3.0 + weight * (k2 - k1), 1e-7);
  const double det = (s + variance) * (s + variance) - k * k;
  const double explained = ((s + variance) * (k1 * k1 + k2 * k2) - 2.0 * k * k1 * k2) / det;
  EXPECT_NEAR(process.At(at).sd, std::sqrt(2.25 - explained), 1e-7);
  const double quadratic = 2.0 * 2.0 * weight;  // (y - m)' K^-1 (y - m)
  EXPECT_NEAR(process.LogLikelihood(),
              -0.5 * quadratic - 0.5 * std::log(det) - std::log(2.0 * std::numbers::pi), 1e-6);
}

TEST(GaussianProcess, FindsWhichParameterMatters) {
  std::vector<ProcessSample> samples;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      Eigen::VectorXd x(2);
      x << i / 4.0, j / 4.0;
      samples.push_back({.x = x, .y = std::sin(6.0 * x(0)), .variance = 1e-4});
    }
  }
  const ProcessShape shape = GaussianProcess::Fitted(samples).shape();
  EXPECT_GT(shape.length(1), 5.0 * shape.length(0));
}

TEST(GaussianProcess, PredictsASmoothFunctionBetweenItsSamples) {
  std::vector<ProcessSample> samples;
  for (int i = 0; i <= 8; ++i)
    samples.push_back({.x = One(i / 8.0), .y = std::cos(5.0 * i / 8.0), .variance = 1e-6});
  const GaussianProcess process = GaussianProcess::Fitted(samples);
  EXPECT_NEAR(process.At(One(0.31)).mean, std::cos(5.0 * 0.31), 0.01);
}

TEST(ExpectedImprovement, HasItsClosedForm) {
  EXPECT_NEAR(ExpectedImprovement({.mean = 1.0, .sd = 2.0}, 1.0),
              2.0 / std::sqrt(2.0 * std::numbers::pi), 1e-12);
  EXPECT_DOUBLE_EQ(ExpectedImprovement({.mean = 1.0, .sd = 0.0}, 4.0), 3.0);
  EXPECT_DOUBLE_EQ(ExpectedImprovement({.mean = 4.0, .sd = 0.0}, 1.0), 0.0);
  EXPECT_NEAR(ExpectedImprovement({.mean = -10.0, .sd = 1.0}, 0.0), 10.0, 1e-6);
}

}  // namespace
}  // namespace limpet
