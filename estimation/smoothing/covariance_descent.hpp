// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "estimation/smoothing/arrow_leaf.hpp"
#include "estimation/smoothing/arrow_stretch.hpp"

namespace limpet {

/// Adds so many rows that follow on one another.
void AppendRows(std::vector<Eigen::Index>& rows, Eigen::Index first, Eigen::Index count);

/// Joint covariance of variables on the way from the root down through the tree: what a stretch has
/// eliminated follows from its ends and the blocks that it depends on.
class CovarianceDescent {
 public:
  /// `whole`: of (last anchor, blocks `slots`, head), which are nodes of the chain.
  CovarianceDescent(const Eigen::MatrixXd& whole, const std::vector<int>& slots, int anchor,
                    int head);

  [[nodiscard]] bool HasPose(int node) const { return poses_.contains(node); }
  [[nodiscard]] bool HasBlock(int slot) const { return blocks_.contains(slot); }
  [[nodiscard]] auto S() const { return S_.topLeftCorner(n_, n_); }
  [[nodiscard]] Eigen::Index RowOf(int node) const { return poses_.at(node); }
  [[nodiscard]] Eigen::Index RowOfBlock(int slot) const { return blocks_.at(slot); }
  /// Descent to the stretch's ends and to the blocks that it depends on alone.
  [[nodiscard]] CovarianceDescent At(const ArrowStretch& stretch) const;

  /// Adds what the stretch eliminated. REQUIRES: its ends and blocks are there.
  void Place(const ArrowStretch& stretch);
  /// Adds all poses inside a leaf from its end down to `node`.
  void WalkInto(const ArrowLeaf& leaf, int node);

 private:
  using Rows = std::vector<Eigen::Index>;

  CovarianceDescent() = default;
  Eigen::Index Add(const ArrowConditional& conditional, const Rows& z);
  /// Adds what was eliminated, given what `z` names in its order.
  Eigen::Index Add(const Eigen::MatrixXd& L, const Eigen::MatrixXd& W, const Rows& z);

  Eigen::MatrixXd S_;  ///< room for more; the first n_ rows and columns count
  Eigen::Index n_ = 0;
  std::map<int, Eigen::Index> poses_;   ///< first row, by node
  std::map<int, Eigen::Index> blocks_;  ///< first row, by slot
};

}  // namespace limpet
