// SPDX-License-Identifier: MIT
// Derivatives of factors that depend on several border variables: these in the order of the
// factor's arguments.
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace limpet {

/// Derivatives of a residual by a pose and N border variables.
template <int kRows, std::size_t N>
struct ObservationJacobians {
  Eigen::Matrix<double, kRows, 6> pose;
  std::array<Eigen::Matrix<double, kRows, 3>, N> border;
};

/// Derivatives of a residual by two neighbouring poses and N border variables.
template <int kRows, std::size_t N>
struct StepJacobians {
  Eigen::Matrix<double, kRows, 6> previous, pose;
  std::array<Eigen::Matrix<double, kRows, 3>, N> border;
};

}  // namespace limpet
