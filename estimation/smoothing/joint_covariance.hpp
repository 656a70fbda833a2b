// SPDX-License-Identifier: MIT
// Covariances of any variables, from the smoother's own factors: down from the root through the
// tree to the leaves that hold a pose that is asked for.
#pragma once

#include <vector>

#include "estimation/smoothing/arrow_estimates.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

struct VariableList {
  std::vector<int> nodes;
  std::vector<int> slots;  ///< of border variables
};

/// Joint, in the order of the list. REQUIRES: the last solve knew the nodes.
[[nodiscard]] JointCovariance CovarianceOf(const VariableList& variables, const ArrowChain& chain,
                                           const ArrowEstimates& estimates, const ArrowRoot& root);

/// Covariances of border variables, each alone, in the order of the list: far less work than all
/// together where many rest. REQUIRES: an update has been.
[[nodiscard]] std::vector<Eigen::Matrix3d> BorderCovariances(const std::vector<int>& slots,
                                                             const ArrowChain& chain,
                                                             const ArrowEstimates& estimates,
                                                             const ArrowRoot& root);

/// Covariances of all poses, each alone: down the tree once, with what the leaves below depend on.
/// REQUIRES: an update has been.
[[nodiscard]] std::vector<NavCovariance> PoseCovariances(const ArrowChain& chain,
                                                         const ArrowRoot& root);

/// Joint covariance of the newest pose and border variables that are not closed: the root's alone.
[[nodiscard]] JointCovariance HeadCovariance(const std::vector<int>& slots,
                                             const ArrowEstimates& estimates,
                                             const ArrowRoot& root);

}  // namespace limpet
