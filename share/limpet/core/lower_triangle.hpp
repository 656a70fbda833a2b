// SPDX-License-Identifier: MIT
// A symmetric matrix as the numbers of its lower triangle, row by row, as it travels and is kept.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// REQUIRES: `matrix` square. Reads the lower triangle.
[[nodiscard]] std::vector<double> LowerTriangleOf(const Eigen::MatrixXd& matrix);
/// The symmetric matrix; nothing if these are not n (n + 1) / 2 finite numbers.
[[nodiscard]] std::optional<Eigen::MatrixXd> FromLowerTriangle(const std::vector<double>& lower);

}  // namespace limpet
