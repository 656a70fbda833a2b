// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_leaf.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limpet {
namespace {

constexpr int kAnchorColumn = 6;  // of the message
constexpr int kBlocksColumn = 12;
constexpr double kCameraRange =
    3.0;  // [m] at which a camera's errors, [rad] or [m], and sizes are felt

/// What a step with so many rows says beyond its earlier pose and the border.
template <int kRows>
void FillLink(const LinearTerm& step, ArrowLink& link) {
  const auto J_previous = step.J_previous.topRows<kRows>();
  const auto J_pose = step.J_pose.topRows<kRows>();
  Eigen::Map<NavCovariance>(link.head_next.data()) = J_previous.transpose() * J_pose;
  Eigen::Map<NavCovariance>(link.next_next.data()) = J_pose.transpose() * J_pose;
  Eigen::Map<NavVector>(link.g_next.data()) = -J_pose.transpose() * step.r.head<kRows>();
  for (std::size_t i = 0; i < link.columns.size(); ++i) {
    Eigen::Map<Eigen::Matrix<double, 6, 3>>(&link.next_border[18 * i]) =
        J_pose.transpose() * step.J_border[i].topRows<kRows>();
  }
}

/// `columns` of the border where the variables begin that the step depends on.
ArrowLink LinkOf(const LinearTerm& step, std::span<const int> columns) {
  ArrowLink link;
  link.columns.assign(columns.begin(), columns.end());
  link.next_border.resize(18 * columns.size());
  constexpr std::array kFill{&FillLink<1>, &FillLink<2>, &FillLink<3>,
                             &FillLink<4>, &FillLink<5>, &FillLink<6>};
  if (step.rows > 0) kFill[AsIndex(step.rows - 1)](step, link);
  return link;
}

}  // namespace

int ArrowLeaf::ColumnOf(int slot, ArrowMessage& message, const std::vector<double>& border) {
  const auto found = std::ranges::find(slots_, slot);
  const auto local = static_cast<int>(found - slots_.begin());
  if (found == slots_.end()) {
    slots_.push_back(slot);
    linearised_.emplace_back(&border[AsIndex(3 * slot)]);
  }
  message.GrowBorder(6 + 3 * static_cast<int>(slots_.size()));
  return kBlocksColumn + 3 * local;
}

ArrowLeaf::TermBlocks ArrowLeaf::BlocksOf(const Term& term, ArrowMessage& message,
                                          const std::vector<double>& border, TermPoint& at) {
  TermBlocks blocks;
  for (const int slot : term.slots())
    blocks.columns[blocks.count++] = ColumnOf(slot, message, border);
  for (std::size_t i = 0; i < blocks.count;
       ++i)  // no block is appended, and so moved, from here on
    at.border[i] = &linearised_[AsIndex((blocks.columns[i] - kBlocksColumn) / 3)];
  return blocks;
}

void ArrowLeaf::AddTerms(const ChainGraph& graph, ArrowMessage& message,
                         const std::vector<double>& border) {
  LinearTerm linear;
  const bool is_anchor = head_ == anchor_;
  const NavVector& x = is_anchor ? x_anchor_ : graph.node(head_).x;
  for (const ChainNode::Entry& entry : graph.node(head_).terms) {
    TermPoint at{.pose = &x};
    const TermBlocks blocks = BlocksOf(entry.term, message, border, at);
    entry.term.Linearize(at, linear);
    std::array<JacobianBlock, 1 + kMostBorders> jacobians{
        JacobianBlock{is_anchor ? kAnchorColumn : 0, 6, linear.J_pose.data()}};
    for (std::size_t i = 0; i < blocks.count; ++i)
      jacobians[1 + i] = {blocks.columns[i], 3, linear.J_border[i].data()};
    message.Add(linear, std::span(jacobians).first(1 + blocks.count));
  }
}

void ArrowLeaf::Extend(const ChainGraph& graph, const std::vector<double>& border) {
  message_.GrowBorder(6);
  AddTerms(graph, message_, border);
  const ChainNode& next = graph.node(head_ + 1);
  const bool is_anchor = head_ == anchor_;
  TermPoint at{.previous = is_anchor ? &x_anchor_ : &graph.node(head_).x, .pose = &next.x};
  LinearTerm linear;
  const TermBlocks blocks = BlocksOf(*next.step, message_, border, at);
  next.step->Linearize(at, linear);
  std::array<JacobianBlock, 2 + kMostBorders> jacobians;
  std::size_t count = 0;
  if (is_anchor) {
    jacobians[count++] = {0, 6, linear.J_pose.data()};
    jacobians[count++] = {kAnchorColumn, 6, linear.J_previous.data()};
  } else {
    jacobians[count++] = {0, 6, linear.J_previous.data()};
  }
  for (std::size_t i = 0; i < blocks.count; ++i)
    jacobians[count++] = {blocks.columns[i], 3, linear.J_border[i].data()};
  message_.Add(linear, std::span(jacobians).first(count));
  if (!is_anchor) {
    std::array<int, kMostBorders> columns = blocks.columns;
    for (int& column : columns)
      column -= 6;
    interior_.push_back(
        EliminateHead(message_, LinkOf(linear, std::span(columns).first(blocks.count))));
  }
  ++head_;
  x_head_ = next.x;
}

ArrowMessage ArrowLeaf::WithHeadTerms(const ChainGraph& graph, const std::vector<double>& border) {
  message_.GrowBorder(6);
  ArrowMessage message = message_;
  AddTerms(graph, message, border);
  message_.GrowBorder(message.border);  // a block of the head's terms is one of the leaf's
  return message;
}

std::vector<double> ArrowLeaf::ChangeOf(const NavVector& x_anchor,
                                        const std::vector<double>& border) const {
  std::vector<double> change(6 + 3 * linearised_.size());
  for (int i = 0; i < 6; ++i)
    change[AsIndex(i)] = x_anchor(i) - x_anchor_(i);
  for (std::size_t b = 0; b < slots_.size(); ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      change[6 + 3 * b + i] =
          border[AsIndex(3 * slots_[b]) + i] - linearised_[b](static_cast<Eigen::Index>(i));
    }
  }
  return change;
}

ArrowLeaf::Displacement ArrowLeaf::DisplacementAt(const Ends& ends,
                                                  const std::vector<double>& border,
                                                  const std::vector<BorderStatus>& status) const {
  const NavVector first = ends.anchor - x_anchor_;
  const NavVector last = head_ == anchor_ ? first : NavVector(ends.head - x_head_);
  Displacement moved{.angle = std::max(first.tail<3>().lpNorm<Eigen::Infinity>(),
                                       last.tail<3>().lpNorm<Eigen::Infinity>())};
  for (std::size_t b = 0; b < slots_.size(); ++b) {
    const BorderKind kind = status[AsIndex(slots_[b])].kind;
    if (kind == BorderKind::kSensorErrors) continue;
    const Eigen::Vector3d off =
        Eigen::Map<const Eigen::Vector3d>(&border[AsIndex(3 * slots_[b])]) - linearised_[b];
    if (kind == BorderKind::kCameraErrors || kind == BorderKind::kObjectSizes) {
      moved.distance = std::max(moved.distance, kCameraRange * off.lpNorm<Eigen::Infinity>());
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      moved.distance =
          std::max({moved.distance, std::abs(off(i) - first(i)), std::abs(off(i) - last(i))});
    }
  }
  return moved;
}

}  // namespace limpet
