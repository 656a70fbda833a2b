// SPDX-License-Identifier: MIT
#include "limpet/tuning/gaussian_process.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "limpet/core/probability.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Added to the variance of every sample, in shares of the signal's: keeps K well conditioned.
constexpr double kJitter = 1e-8;

}  // namespace

double ProcessShape::Kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  const double s = std::sqrt(5.0) * ((a - b).array() / length.array()).matrix().norm();
  return signal * signal * (1.0 + s + s * s / 3.0) * std::exp(-s);
}

GaussianProcess::GaussianProcess(std::vector<ProcessSample> samples, ProcessShape shape)
    : samples_(std::move(samples)), shape_(std::move(shape)) {
  LIMPET_REQUIRE(!samples_.empty(), "a process without samples");
  const auto count = static_cast<Eigen::Index>(samples_.size());
  Eigen::MatrixXd covariance(count, count);
  Eigen::VectorXd y(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const ProcessSample& sample = samples_[static_cast<std::size_t>(i)];
    y(i) = sample.y;
    for (Eigen::Index j = 0; j <= i; ++j) {
      covariance(i, j) = shape_.Kernel(sample.x, samples_[static_cast<std::size_t>(j)].x);
      covariance(j, i) = covariance(i, j);
    }
    covariance(i, i) += sample.variance + kJitter * shape_.signal * shape_.signal;
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
  factor_ = cholesky.matrixL();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  const Eigen::VectorXd of_ones = cholesky.solve(ones);
  mean_ = of_ones.dot(y) / of_ones.sum();
  const Eigen::VectorXd residual = y - mean_ * ones;
  weights_ = cholesky.solve(residual);
  log_likelihood_ = -0.5 * residual.dot(weights_) - factor_.diagonal().array().log().sum() -
                    0.5 * static_cast<double>(count) * std::log(2.0 * std::numbers::pi);
}

Prediction GaussianProcess::At(const Eigen::VectorXd& x) const {
  const auto count = static_cast<Eigen::Index>(samples_.size());
  Eigen::VectorXd kernel(count);
  for (Eigen::Index i = 0; i < count; ++i)
    kernel(i) = shape_.Kernel(x, samples_[static_cast<std::size_t>(i)].x);
  const Eigen::VectorXd whitened = factor_.triangularView<Eigen::Lower>().solve(kernel);
  const double variance = shape_.signal * shape_.signal - whitened.squaredNorm();
  return {.mean = mean_ + kernel.dot(weights_), .sd = std::sqrt(std::max(0.0, variance))};
}

double ExpectedImprovement(const Prediction& prediction, double best) {
  const double gain = best - prediction.mean;
  if (prediction.sd <= 0.0) return std::max(0.0, gain);
  const double z = gain / prediction.sd;
  return gain * StandardNormalShareBelow(z) + prediction.sd * StandardNormalDensity(z);
}

}  // namespace limpet
