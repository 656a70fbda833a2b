// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimation/smoothing/arrow_leaf.hpp"

namespace limpet {

/// Fixed values that changes count from once leaves are joined: no estimate moves them.
struct ArrowOrigin {
  std::vector<NavVector> anchors;
  std::vector<double> border;  ///< three per block
};

/// Slow errors of the sensors that no later leaf depends on, so that they need not stay in the
/// border.
struct ClosedBlock {
  struct OwnTerm {
    LinearTerm linear;       ///< its residual where the changes are zero
    std::vector<int> slots;  ///< of the variables, this one first
  };
  int slot = 0;
  LeafRange leaves;  ///< that depend on it
  std::vector<OwnTerm> terms;
};

/// Several leaves in a row, all between their two ends eliminated: what they say about the ends and
/// the blocks that they touch, as changes from the origin; and how what was eliminated last follows
/// from those.
struct ArrowStretch {
  struct Block {
    int slot = 0;
    Eigen::Matrix3d L = Eigen::Matrix3d::Identity();
    Eigen::Vector3d d = Eigen::Vector3d::Zero();
    std::vector<double> W;   ///< 3 x (ends, blocks), column by column
    std::vector<int> slots;  ///< of those blocks
  };
  int first = 0, end = 0;  ///< leaves `first` to `end` - 1, so anchors `first` and `end`
  bool has_begin = true;   ///< variables (end, begin, blocks); without it, the begin is gone too
  std::vector<int> slots;
  ArrowMessage message;
  int middle = 0;  ///< the anchor that was eliminated
  ArrowConditional conditional;
  std::vector<int> middle_slots;  ///< blocks that it depends on, after the end and the begin
  std::vector<Block> blocks;      ///< eliminated after it, in this order

  /// The stretch of a leaf that is closed.
  [[nodiscard]] static ArrowStretch Of(const ArrowLeaf& leaf, int number,
                                       const ArrowOrigin& origin);
  /// Before the first leaf: only the first anchor, nothing known of it.
  [[nodiscard]] static ArrowStretch Nothing();
  /// Multiply-adds of a join that leads to it.
  [[nodiscard]] double Work() const;
};

/// Two in a row as one. Blocks that are closed and touched by no leaf outside are eliminated.
[[nodiscard]] ArrowStretch Join(const ArrowStretch& left, const ArrowStretch& right,
                                std::span<const ClosedBlock> closed);

}  // namespace limpet
