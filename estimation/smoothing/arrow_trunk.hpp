// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "estimation/smoothing/arrow_leaf.hpp"

namespace limpet {

/// Fixed values that the trunk's changes count from: no estimate moves them.
struct ArrowOrigin {
  std::vector<NavVector> anchors;
  std::vector<double> border;  ///< three per block
};

/// The chain of anchors with the whole border: what is left once each leaf has eliminated its
/// inside. Anchors are eliminated in order of time.
class ArrowTrunk {
 public:
  /// An empty trunk at the first anchor.
  ArrowTrunk() = default;
  /// One that continues `other` from its last checkpoint at or before `anchor`.
  ArrowTrunk(const ArrowTrunk& other, int anchor);

  /// Takes the leaf that begins at the head, whose other end becomes the head.
  void Append(const ArrowLeaf& leaf, const ArrowOrigin& origin);
  /// Goes back to the checkpoint at or before `anchor`.
  void Rewind(int anchor);
  /// Puts a newer continuation in place of what lies behind its beginning.
  void Splice(ArrowTrunk&& newer);

  [[nodiscard]] int first() const { return first_; }
  /// Number of the anchor that the message is at; those before it are eliminated.
  [[nodiscard]] int head() const { return head_; }
  [[nodiscard]] const ArrowMessage& message() const { return message_; }
  [[nodiscard]] const ArrowConditional& conditional(int anchor) const {
    return conditionals_[static_cast<std::size_t>(anchor - first_)];
  }
  [[nodiscard]] static int CheckpointBefore(int anchor);
  /// Multiply-adds that appending one leaf takes with that many columns of the border.
  [[nodiscard]] static double WorkOf(int columns) {
    const double n = 6.0 + columns;
    return 6.0 * n * n + 2000.0;
  }

 private:
  int first_ = 0, head_ = 0;
  ArrowMessage message_;
  std::vector<ArrowConditional> conditionals_;
  std::map<int, ArrowMessage> checkpoints_;
};

}  // namespace limpet
