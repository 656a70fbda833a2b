// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_stretch.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Cholesky>

namespace limpet {
namespace {

constexpr double kFaintInformation = 1e-8;  // that holds what nothing observes

/// The leaf's gradient where changes count from.
std::vector<double> RebasedGradient(const ArrowLeaf& leaf, int number, const ArrowOrigin& origin) {
  const ArrowMessage& message = leaf.message();
  const int n = message.size();
  std::vector<double> off(AsIndex(n)), g = message.g;
  for (int i = 0; i < 6; ++i) {
    off[AsIndex(i)] = origin.anchors[AsIndex(number + 1)](i) - leaf.x_head()(i);
    off[AsIndex(6 + i)] = origin.anchors[AsIndex(number)](i) - leaf.x_anchor()(i);
  }
  for (std::size_t b = 0; b < leaf.slots().size(); ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      off[12 + 3 * b + i] = origin.border[AsIndex(3 * leaf.slots()[b]) + i] -
                            leaf.linearised()[b](static_cast<Eigen::Index>(i));
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

/// Position of a slot among a stretch's blocks; new ones are appended.
int PositionOf(int slot, std::vector<int>& slots) {
  const auto found = std::ranges::find(slots, slot);
  const auto position = static_cast<int>(found - slots.begin());
  if (found == slots.end()) slots.push_back(slot);
  return position;
}

/// The message without the variable of three that begins at a column.
ArrowMessage Without(const ArrowMessage& message, int column) {
  ArrowMessage less;
  less.GrowBorder(message.border - 3);
  for (int c = 0; c < less.size(); ++c) {
    const int from_c = c < column ? c : c + 3;
    for (int r = c; r < less.size(); ++r)
      less.at(r, c) = message.at(r < column ? r : r + 3, from_c);
    less.g[AsIndex(c)] = message.g[AsIndex(from_c)];
  }
  return less;
}

void Eliminate(ArrowStretch& stretch, const ClosedBlock& closed) {
  const int first = stretch.has_begin ? 12 : 6;
  const int column = first + 3 * PositionOf(closed.slot, stretch.slots);
  for (const ClosedBlock::OwnTerm& term : closed.terms) {
    std::array<JacobianBlock, kMostBorders> blocks;
    for (std::size_t i = 0; i < term.slots.size(); ++i) {
      blocks[i] = {first + 3 * PositionOf(term.slots[i], stretch.slots), 3,
                   term.linear.J_border[i].data()};
    }
    stretch.message.GrowBorder(first - 6 + 3 * static_cast<int>(stretch.slots.size()));
    stretch.message.Add(term.linear, std::span(blocks).first(term.slots.size()));
  }
  const ArrowMessage& message = stretch.message;
  Eigen::Matrix<double, 3, Eigen::Dynamic> W(3, message.size() - 3);
  Eigen::Matrix3d own;
  Eigen::Vector3d g;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j)
      own(i, j) = own(j, i) = message.at(column + i, column + j);
    own(i, i) += kFaintInformation;
    g(i) = message.g[AsIndex(column + i)];
    for (int c = 0; c < W.cols(); ++c) {
      const int from = c < column ? c : c + 3;
      W(i, c) = message.at(std::max(from, column + i), std::min(from, column + i));
    }
  }
  ArrowStretch::Block block{
      .slot = closed.slot, .L = own.llt().matrixL(), .d = g, .W = {}, .slots = {}};
  const auto L = block.L.triangularView<Eigen::Lower>();
  L.solveInPlace(block.d);
  L.solveInPlace(W);
  ArrowMessage less = Without(message, column);
  for (int c = 0; c < less.size(); ++c) {
    for (int r = c; r < less.size(); ++r)
      less.at(r, c) -= W.col(r).dot(W.col(c));
    less.g[AsIndex(c)] -= W.col(c).dot(block.d);
  }
  stretch.message = std::move(less);
  std::erase(stretch.slots, closed.slot);
  block.W.assign(W.data(), W.data() + W.size());
  block.slots = stretch.slots;
  stretch.blocks.push_back(std::move(block));
}

}  // namespace

ArrowStretch ArrowStretch::Of(const ArrowLeaf& leaf, int number, const ArrowOrigin& origin) {
  ArrowStretch stretch;
  stretch.first = number;
  stretch.end = number + 1;
  stretch.slots = leaf.slots();
  stretch.message = leaf.message();
  stretch.message.g = RebasedGradient(leaf, number, origin);
  return stretch;
}

ArrowStretch ArrowStretch::Nothing() {
  ArrowStretch stretch;
  stretch.has_begin = false;
  return stretch;
}

double ArrowStretch::Work() const {
  const double n = conditional.columns();
  return 6.0 * n * n + 2000.0;
}

ArrowStretch Join(const ArrowStretch& left, const ArrowStretch& right,
                  std::span<const ClosedBlock> closed) {
  ArrowStretch joined;
  joined.first = left.first;
  joined.end = right.end;
  joined.middle = left.end;
  joined.has_begin = left.has_begin;
  joined.slots = left.slots;
  // Where the right one's variables (end, begin, blocks) go: its begin is the left one's end.
  const ArrowMessage& from = right.message;
  const int blocks = left.has_begin ? 6 : 0;  // column of the border where they begin
  std::vector<int> place(AsIndex(from.size()), 0);
  ArrowLink link;
  for (int i = 0; i < 6; ++i)
    place[AsIndex(6 + i)] = i;
  for (std::size_t b = 0; b < right.slots.size(); ++b) {
    const int column = blocks + 3 * PositionOf(right.slots[b], joined.slots);
    link.columns.push_back(column);
    for (int i = 0; i < 3; ++i)
      place[12 + 3 * b + AsIndex(i)] = 6 + column + i;
  }
  ArrowMessage message = left.message;
  message.GrowBorder(blocks + 3 * static_cast<int>(joined.slots.size()));
  for (int c = 6; c < from.size(); ++c) {
    for (int r = c; r < from.size(); ++r) {
      const int a = place[AsIndex(r)], b = place[AsIndex(c)];
      message.at(std::max(a, b), std::min(a, b)) += from.at(r, c);
    }
    message.g[AsIndex(place[AsIndex(c)])] += from.g[AsIndex(c)];
  }
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r)
      link.next_next[AsIndex(6 * c + r)] = from.at(r, c);
    for (int r = 0; r < 6; ++r)
      link.head_next[AsIndex(6 * c + r)] = from.at(6 + r, c);
    link.g_next[AsIndex(c)] = from.g[AsIndex(c)];
  }
  for (int column = 12; column < from.size(); ++column) {
    for (int c = 0; c < 6; ++c)
      link.next_border.push_back(from.at(column, c));
  }
  joined.conditional = EliminateHead(message, link);
  joined.middle_slots = joined.slots;
  joined.message = std::move(message);
  for (const ClosedBlock& block : closed) {
    const bool is_inside = block.leaves.first >= joined.first && block.leaves.last < joined.end;
    if (is_inside && std::ranges::count(joined.slots, block.slot) > 0) Eliminate(joined, block);
  }
  return joined;
}

}  // namespace limpet
