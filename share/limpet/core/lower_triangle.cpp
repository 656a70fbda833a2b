// SPDX-License-Identifier: MIT
#include "limpet/core/lower_triangle.hpp"

#include <cmath>

namespace limpet {

std::vector<double> LowerTriangleOf(const Eigen::MatrixXd& matrix) {
  std::vector<double> lower;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j)
      lower.push_back(matrix(i, j));
  }
  return lower;
}

std::optional<Eigen::MatrixXd> FromLowerTriangle(const std::vector<double>& lower) {
  Eigen::Index n = 0;
  while (n * (n + 1) / 2 < static_cast<Eigen::Index>(lower.size()))
    ++n;
  if (n * (n + 1) / 2 != static_cast<Eigen::Index>(lower.size())) {
    return std::nullopt;
  }
  Eigen::MatrixXd matrix(n, n);
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j)
      matrix(i, j) = matrix(j, i) = lower[next++];
  }
  return matrix.allFinite() ? std::optional(matrix) : std::nullopt;
}

}  // namespace limpet
