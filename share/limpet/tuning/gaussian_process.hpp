// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limpet {

/// One place where a function was measured.
struct ProcessSample {
  Eigen::VectorXd x;  ///< each coordinate scaled to [0, 1]
  double y = 0.0;
  double variance = 0.0;  ///< of y's error
};

/// What a Gaussian process takes a function for: its kernel is
/// signal^2 (1 + s + s^2 / 3) exp(-s), s^2 = 5 sum_i (dx_i / length_i)^2 (Matern, 5/2).
struct ProcessShape {
  Eigen::VectorXd length;
  double signal = 1.0;  ///< standard deviation
  [[nodiscard]] double Kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
};

struct Prediction {
  double mean = 0.0;
  double sd = 0.0;
};

/// Regression of a smooth function by a Gaussian process around a constant mean, which is estimated
/// by generalised least squares.
class GaussianProcess {
 public:
  /// REQUIRES: samples.
  GaussianProcess(std::vector<ProcessSample> samples, ProcessShape shape);
  /// The shape that makes the samples most likely, among lengths from 0.05 to 20 and signals from a
  /// tenth to ten times the samples' spread. Deterministic.
  [[nodiscard]] static GaussianProcess Fitted(const std::vector<ProcessSample>& samples);

  [[nodiscard]] Prediction At(const Eigen::VectorXd& x) const;
  /// ln p(y | x, shape, mean).
  [[nodiscard]] double LogLikelihood() const { return log_likelihood_; }
  [[nodiscard]] const ProcessShape& shape() const { return shape_; }
  [[nodiscard]] double mean() const { return mean_; }

 private:
  std::vector<ProcessSample> samples_;
  ProcessShape shape_;
  double mean_ = 0.0;
  double log_likelihood_ = 0.0;
  Eigen::MatrixXd factor_;   ///< L of K = L L'
  Eigen::VectorXd weights_;  ///< K^-1 (y - mean)
};

/// By how much a value drawn from `prediction` is expected to be below `best`; more is counted,
/// less is 0.
[[nodiscard]] double ExpectedImprovement(const Prediction& prediction, double best);

}  // namespace limpet
