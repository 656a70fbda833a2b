// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/smoothing/arrow_leaf.hpp"

namespace limpet {

/// The end of the elimination: last anchor with the whole border, factorised once per anchor, and
/// the newest leaf upon it, solved at every update with only the blocks that it touches.
class ArrowRoot {
 public:
  ArrowRoot();
  ~ArrowRoot();
  ArrowRoot(const ArrowRoot&) = delete;
  ArrowRoot& operator=(const ArrowRoot&) = delete;
  ArrowRoot(ArrowRoot&&) noexcept;
  ArrowRoot& operator=(ArrowRoot&&) noexcept;

  /// `message`: all that is known of the last anchor and of the blocks `slots`, as changes from
  /// `anchor` and `border` (three per slot of the graph). Directions that nothing observes are
  /// held.
  void SetPrior(const ArrowMessage& message, const std::vector<int>& slots, const NavVector& anchor,
                const std::vector<double>& border);
  /// Joins the newest leaf: `message` of (head, anchor, blocks), where the leaf is linearised.
  void Solve(const ArrowLeaf& leaf, const ArrowMessage& message);

  [[nodiscard]] const NavVector& head() const { return head_; }
  [[nodiscard]] const NavVector& anchor() const { return anchor_; }
  /// Three per block, in the order of `slots()`.
  [[nodiscard]] const std::vector<double>& border() const { return border_; }
  [[nodiscard]] const std::vector<int>& slots() const;
  /// Joint covariance of the head pose (first six) and of blocks of the border (three each).
  [[nodiscard]] Eigen::MatrixXd Covariance(const std::vector<int>& slots) const;
  /// Covariance of the last anchor (first six), the border in the order of `slots()` and the head
  /// (last six): the anchor again while the newest leaf is empty.
  [[nodiscard]] Eigen::MatrixXd WholeCovariance() const;
  /// Directions of the head pose (NavIndex) that nothing observes.
  [[nodiscard]] const std::vector<int>& held() const { return held_; }

 private:
  struct Prior;
  /// A slot of the graph (three columns); nothing: the anchor (six).
  using Block = std::optional<int>;
  [[nodiscard]] const Eigen::MatrixXd& PriorColumns(Block block) const;
  /// The prior of these blocks, `size` unknowns together; nothing to do while they stay the same.
  void SelectPrior(const std::vector<Block>& blocks, Eigen::Index size);

  std::unique_ptr<Prior> prior_;
  std::vector<int> held_;
  NavVector head_ = NavVector::Zero(), anchor_ = NavVector::Zero();
  std::vector<double> border_;
};

}  // namespace limpet
