// SPDX-License-Identifier: MIT
#include "estimation/smoothing/joint_prior.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>

#include "limpet/core/require.hpp"

namespace limpet {

JointPrior::JointPrior(std::vector<int> slots, Eigen::VectorXd mean, Eigen::MatrixXd covariance)
    : slots_(std::move(slots)), mean_(std::move(mean)), covariance_(std::move(covariance)) {
  const auto n = static_cast<Eigen::Index>(3 * slots_.size());
  LIMPET_REQUIRE(mean_.size() == n && covariance_.rows() == n && covariance_.cols() == n,
                 "a joint prior has three rows per landmark");
  const Eigen::LLT<Eigen::MatrixXd> llt(covariance_);
  LIMPET_REQUIRE(llt.info() == Eigen::Success, "a covariance is positive definite");
  information_ = llt.solve(Eigen::MatrixXd::Identity(n, n));
}

JointPrior JointPrior::Without(int slot) const {
  std::vector<int> slots;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i] == slot) continue;
    slots.push_back(slots_[i]);
    for (std::size_t k = 0; k < 3; ++k)
      rows.push_back(static_cast<Eigen::Index>(3 * i + k));
  }
  return {std::move(slots), mean_(rows), covariance_(rows, rows)};
}

double JointPrior::Cost(const Eigen::VectorXd& places) const {
  const Eigen::VectorXd off = places - mean_;
  return 0.5 * off.dot(information_ * off);
}

}  // namespace limpet
