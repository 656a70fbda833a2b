// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limpet {

/// What is known of several landmarks together: a Gaussian over their places, with all its
/// correlations. Cost 0.5 (p - mean)' covariance^-1 (p - mean).
class JointPrior {
 public:
  /// `mean`, `covariance`: three rows per slot, in the order of `slots`; world frame, m and m^2.
  /// REQUIRES: sizes agree; covariance symmetric and positive definite.
  JointPrior(std::vector<int> slots, Eigen::VectorXd mean, Eigen::MatrixXd covariance);

  /// The prior of the other landmarks alone: `slot` is no longer asked about.
  [[nodiscard]] JointPrior Without(int slot) const;

  [[nodiscard]] const std::vector<int>& slots() const { return slots_; }
  [[nodiscard]] const Eigen::VectorXd& mean() const { return mean_; }
  [[nodiscard]] const Eigen::MatrixXd& information() const { return information_; }
  /// `places`: three rows per slot.
  [[nodiscard]] double Cost(const Eigen::VectorXd& places) const;

 private:
  std::vector<int> slots_;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_, information_;
};

}  // namespace limpet
