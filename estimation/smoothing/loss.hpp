// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace limpet {

/// Huber's robust loss [Huber 1964] of a whitened residual's norm; with an infinite threshold,
/// least squares.
struct Loss {
  double threshold = std::numeric_limits<double>::infinity();

  [[nodiscard]] static Loss LeastSquares() { return {}; }
  [[nodiscard]] static Loss Huber(double threshold) { return {threshold}; }

  /// Factor on residual and Jacobian for one step of iteratively reweighted least squares.
  [[nodiscard]] double SqrtWeight(double norm) const {
    return norm <= threshold ? 1.0 : std::sqrt(threshold / norm);
  }
  [[nodiscard]] double Cost(double norm) const {
    return norm <= threshold ? 0.5 * norm * norm : threshold * (norm - 0.5 * threshold);
  }
};

}  // namespace limpet
