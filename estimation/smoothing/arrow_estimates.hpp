// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/smoothing/arrow_chain.hpp"
#include "estimation/smoothing/arrow_root.hpp"

namespace limpet {

/// The newest solution: the root's at once, and what lies further down the tree as far as it is
/// asked for. Const functions fill in on demand, so one thread at a time.
class ArrowEstimates {
 public:
  /// `chain` must outlive it.
  explicit ArrowEstimates(const ArrowChain& chain) : chain_(&chain) {}

  void AddBorderVariable(int slot, const Eigen::Vector3d& start);
  /// An anchor that no solve has seen yet.
  void AddAnchor(const NavVector& x);
  /// A new solution begins with the root's; what was filled in before is old.
  void Take(const ArrowRoot& root);
  /// Forgets the leaf's estimates; to be called when a leaf has been linearised anew.
  void ForgetLeafEstimates() { estimated_leaf_.reset(); }
  /// Border estimates in place of those of the last solve, three per slot.
  void SetBorder(const std::vector<double>& border) { border_ = border; }

  /// Three per slot; those of closed variables as of the last time they were solved for.
  [[nodiscard]] const std::vector<double>& border() const { return border_; }
  [[nodiscard]] Eigen::Vector3d BorderAt(int slot) const;
  /// True if the root knew the variable in the last solve.
  [[nodiscard]] bool IsSolved(int slot) const { return is_solved_[AsIndex(slot)]; }
  [[nodiscard]] NavVector PoseAt(int node) const;
  /// Estimate of an anchor, as it was filled in last.
  [[nodiscard]] const NavVector& Anchor(int i) const { return anchors_[AsIndex(i)]; }
  [[nodiscard]] const NavVector& LastAnchor() const { return anchors_.back(); }
  /// Estimates of all poses of a leaf, its ends included.
  [[nodiscard]] const std::vector<NavVector>& LeafEstimates(int leaf) const;
  /// Fills in what the stretch has eliminated. REQUIRES: its ends are filled in.
  void SolveStretch(const ArrowStretch& stretch) const;

 private:
  /// Fills in the leaf's ends and all border variables that it touches.
  void SolveEndsOf(int leaf) const;
  [[nodiscard]] const ArrowOrigin& origin() const { return chain_->tree().origin; }
  /// Changes from the origin of the stretch's begin, if it has one, then of border variables.
  [[nodiscard]] std::vector<double> ChangesOf(const ArrowStretch& stretch,
                                              const std::vector<int>& slots) const;
  void SolveBlock(const ArrowStretch& stretch, const ArrowStretch::Block& block,
                  const NavVector& end) const;

  const ArrowChain* chain_;
  std::vector<bool> is_solved_;  ///< by slot
  NavVector head_ = NavVector::Zero();
  mutable std::vector<double> border_;         ///< three per slot
  mutable std::vector<double> border_change_;  ///< from the origin, likewise
  mutable std::vector<NavVector> anchors_;
  mutable std::vector<int> solved_at_;  ///< per anchor: number of the solution it was filled in for
  int solution_ = 0;
  mutable std::optional<int> estimated_leaf_;  ///< whose poses leaf_estimates_ holds
  mutable std::vector<NavVector> leaf_estimates_;
};

}  // namespace limpet
