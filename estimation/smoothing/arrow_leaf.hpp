// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "estimation/smoothing/arrow_elimination.hpp"
#include "estimation/smoothing/border_status.hpp"
#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// A stretch of the chain from one anchor pose to the next, the poses between eliminated: what it
/// says about its two ends and the few blocks of the border that it touches. Grows pose by pose
/// while it is the newest. Remembers where it was linearised, so that its neighbours need not be
/// linearised with it.
class ArrowLeaf {
 public:
  static constexpr int kNodes = 16;  ///< of a leaf that is full
  /// Estimates of the two poses that a leaf lies between.
  struct Ends {
    NavVector anchor, head;
  };

  ArrowLeaf() = default;
  /// Begins at `anchor`, linearised at `x`.
  ArrowLeaf(int anchor, const NavVector& x) : anchor_(anchor), head_(anchor), x_anchor_(x) {}

  /// Takes in the terms of the present head and the step to the next node, linearised where the
  /// graph's node is; `border` holds the estimates of all blocks.
  void Extend(const ChainGraph& graph, const std::vector<double>& border);
  /// The message with the terms of the head, which may still grow: variables (head, anchor,
  /// blocks); while the head is the anchor, the first six are empty.
  [[nodiscard]] ArrowMessage WithHeadTerms(const ChainGraph& graph,
                                           const std::vector<double>& border);

  [[nodiscard]] int anchor() const { return anchor_; }
  [[nodiscard]] int head() const { return head_; }
  [[nodiscard]] const std::vector<int>& slots() const { return slots_; }
  /// Blocks' values where the leaf is linearised.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& linearised() const { return linearised_; }
  [[nodiscard]] const NavVector& x_anchor() const { return x_anchor_; }
  [[nodiscard]] const NavVector& x_head() const { return x_head_; }
  /// Message over (head, anchor, blocks), without terms of the head.
  [[nodiscard]] const ArrowMessage& message() const { return message_; }
  /// Estimates of the poses between, newest first to oldest, given the ends and the border.
  template <class Take>
  void BackSubstituteInterior(const ChainGraph& graph, const Ends& ends,
                              const std::vector<double>& border, Take take) const {
    std::vector<double> change = ChangeOf(ends.anchor, border);
    NavVector next = ends.head - x_head_;
    for (int node = head_ - 1; node > anchor_; --node) {
      next = BackSubstitute(Interior(node), next, change.data());
      take(node, NavVector(graph.node(node).x + next));
    }
  }
  [[nodiscard]] const ArrowConditional& Interior(int node) const {
    return interior_[static_cast<std::size_t>(node - anchor_ - 1)];
  }
  /// The largest change since linearisation that matters: of the ends' headings [rad], and of the
  /// landmarks against the ends [m]; a shift of all together does not.
  struct Displacement {
    double angle = 0.0, distance = 0.0;
  };
  [[nodiscard]] Displacement DisplacementAt(const Ends& ends, const std::vector<double>& border,
                                            const std::vector<BorderStatus>& status) const;

 private:
  /// First columns of a term's blocks in the message.
  struct TermBlocks {
    std::array<int, kMostBorders> columns{};
    std::size_t count = 0;
  };
  /// Also sets where the term is linearised: where the leaf is.
  TermBlocks BlocksOf(const Term& term, ArrowMessage& message, const std::vector<double>& border,
                      TermPoint& at);
  void AddTerms(const ChainGraph& graph, ArrowMessage& message, const std::vector<double>& border);
  /// First column of a block in the message; new blocks are appended.
  int ColumnOf(int slot, ArrowMessage& message, const std::vector<double>& border);
  [[nodiscard]] std::vector<double> ChangeOf(const NavVector& x_anchor,
                                             const std::vector<double>& border) const;

  int anchor_ = 0, head_ = 0;
  NavVector x_anchor_ = NavVector::Zero(), x_head_ = NavVector::Zero();
  std::vector<int> slots_;
  std::vector<Eigen::Vector3d> linearised_;
  std::vector<ArrowConditional> interior_;
  ArrowMessage message_;
};

}  // namespace limpet
