// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_trunk.hpp"

#include <algorithm>
#include <utility>

namespace limpet {
namespace {

constexpr int kCheckpointEvery = 8;  // anchors

/// The leaf's gradient where the trunk's changes count from.
std::vector<double> RebasedGradient(const ArrowLeaf& leaf, int anchor, const ArrowOrigin& origin) {
  const ArrowMessage& message = leaf.message();
  const int n = message.size();
  std::vector<double> off(AsIndex(n)), g = message.g;
  for (int i = 0; i < 6; ++i) {
    off[AsIndex(i)] = origin.anchors[AsIndex(anchor + 1)](i) - leaf.x_head()(i);
    off[AsIndex(6 + i)] = origin.anchors[AsIndex(anchor)](i) - leaf.x_anchor()(i);
  }
  for (std::size_t b = 0; b < leaf.slots().size(); ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      off[12 + 3 * b + i] =
          origin.border[AsIndex(3 * leaf.slots()[b]) + i] - leaf.linearised()[3 * b + i];
    }
  }
  for (int c = 0; c < n; ++c) {
    const double* column = &message.A[AsIndex(c) * AsIndex(n)];
    double sum = column[c] * off[AsIndex(c)];
    for (int i = c + 1; i < n; ++i) {
      sum += column[i] * off[AsIndex(i)];
      g[AsIndex(i)] -= column[i] * off[AsIndex(c)];
    }
    g[AsIndex(c)] -= sum;
  }
  return g;
}

}  // namespace

int ArrowTrunk::CheckpointBefore(int anchor) {
  return anchor / kCheckpointEvery * kCheckpointEvery;
}

ArrowTrunk::ArrowTrunk(const ArrowTrunk& other, int anchor) {
  first_ = head_ = CheckpointBefore(std::min(anchor, other.head_));
  if (const auto found = other.checkpoints_.find(first_); found != other.checkpoints_.end()) {
    message_ = found->second;
  } else if (first_ == other.head_) {
    message_ = other.message_;
  }
}

void ArrowTrunk::Rewind(int anchor) {
  if (anchor >= head_) {
    return;
  }
  head_ = CheckpointBefore(anchor);
  message_ = checkpoints_.at(head_);
  conditionals_.resize(AsIndex(head_ - first_));
}

void ArrowTrunk::Append(const ArrowLeaf& leaf, const ArrowOrigin& origin) {
  if (head_ % kCheckpointEvery == 0) {
    checkpoints_[head_] = message_;
  }
  const ArrowMessage& from = leaf.message();
  const std::vector<double> g = RebasedGradient(leaf, head_, origin);
  // Where the leaf's variables are in the message: the anchor is its head.
  std::vector<int> place(AsIndex(from.size()), 0);
  int columns = message_.border;
  for (int i = 0; i < 6; ++i)
    place[AsIndex(6 + i)] = i;
  for (std::size_t b = 0; b < leaf.slots().size(); ++b) {
    const int column = 3 * leaf.slots()[b];
    columns = std::max(columns, column + 3);
    for (int i = 0; i < 3; ++i)
      place[12 + 3 * b + AsIndex(i)] = 6 + column + i;
  }
  message_.GrowBorder(columns);
  for (int c = 6; c < from.size(); ++c) {
    for (int r = c; r < from.size(); ++r) {
      const int a = place[AsIndex(r)], b = place[AsIndex(c)];
      message_.at(std::max(a, b), std::min(a, b)) += from.at(r, c);
    }
    message_.g[AsIndex(place[AsIndex(c)])] += g[AsIndex(c)];
  }
  ArrowLink link;
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r)
      link.next_next[AsIndex(6 * c + r)] = from.at(r, c);
    for (int r = 0; r < 6; ++r)
      link.head_next[AsIndex(6 * c + r)] = from.at(6 + r, c);
    link.g_next[AsIndex(c)] = g[AsIndex(c)];
  }
  for (std::size_t b = 0; b < leaf.slots().size(); ++b) {
    link.columns.push_back(3 * leaf.slots()[b]);
    for (int i = 0; i < 3; ++i) {
      for (int c = 0; c < 6; ++c) {
        link.next_border.push_back(from.at(12 + 3 * static_cast<int>(b) + i, c));
      }
    }
  }
  conditionals_.push_back(EliminateHead(message_, link));
  ++head_;
}

void ArrowTrunk::Splice(ArrowTrunk&& newer) {
  conditionals_.resize(AsIndex(newer.first_ - first_));
  std::ranges::move(newer.conditionals_, std::back_inserter(conditionals_));
  checkpoints_.erase(checkpoints_.lower_bound(newer.first_), checkpoints_.end());
  checkpoints_.merge(newer.checkpoints_);
  message_ = std::move(newer.message_);
  head_ = newer.head_;
}

}  // namespace limpet
