// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_leaf.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limpet {
namespace {

constexpr int kAnchorColumn = 6;  // of the message
constexpr int kBlocksColumn = 12;

/// What a step with so many rows says beyond its earlier pose and the border.
template <int kRows>
void FillLink(const LinearTerm& step, ArrowLink& link) {
  const auto J_previous = step.J_previous.topRows<kRows>();
  const auto J_pose = step.J_pose.topRows<kRows>();
  Eigen::Map<NavCovariance>(link.head_next.data()) = J_previous.transpose() * J_pose;
  Eigen::Map<NavCovariance>(link.next_next.data()) = J_pose.transpose() * J_pose;
  Eigen::Map<NavVector>(link.g_next.data()) = -J_pose.transpose() * step.r.head<kRows>();
  if (!link.columns.empty()) {
    Eigen::Map<Eigen::Matrix<double, 6, 3>>(link.next_border.data()) =
        J_pose.transpose() * step.J_border.topRows<kRows>();
  }
}

/// `column` of the border where the variable begins that the step depends on, if any.
ArrowLink LinkOf(const LinearTerm& step, std::optional<int> column) {
  ArrowLink link;
  if (column) {
    link.columns.push_back(*column);
    link.next_border.resize(18);
  }
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
    linearised_.insert(linearised_.end(), border.begin() + 3 * slot, border.begin() + 3 * slot + 3);
  }
  message.GrowBorder(6 + 3 * static_cast<int>(slots_.size()));
  return kBlocksColumn + 3 * local;
}

void ArrowLeaf::AddTerms(const ChainGraph& graph, ArrowMessage& message,
                         const std::vector<double>& border) {
  LinearTerm linear;
  const bool is_anchor = head_ == anchor_;
  const NavVector& x = is_anchor ? x_anchor_ : graph.node(head_).x;
  for (const ChainNode::Entry& entry : graph.node(head_).terms) {
    std::array<JacobianBlock, 2> blocks{
        JacobianBlock{is_anchor ? kAnchorColumn : 0, 6, linear.J_pose.data()}, {}};
    TermPoint at{.pose = &x};
    Eigen::Vector3d p;
    const std::optional<int> slot = entry.term.border();
    if (slot) {
      blocks[1] = {ColumnOf(*slot, message, border), 3, linear.J_border.data()};
      p = Eigen::Map<const Eigen::Vector3d>(&linearised_[AsIndex(blocks[1].first - kBlocksColumn)]);
      at.border = &p;
    }
    entry.term.Linearize(at, linear);
    message.Add(linear, std::span(blocks).first(slot ? 2 : 1));
  }
}

void ArrowLeaf::Extend(const ChainGraph& graph, const std::vector<double>& border) {
  message_.GrowBorder(6);
  AddTerms(graph, message_, border);
  const ChainNode& next = graph.node(head_ + 1);
  const bool is_anchor = head_ == anchor_;
  TermPoint at{.previous = is_anchor ? &x_anchor_ : &graph.node(head_).x, .pose = &next.x};
  LinearTerm linear;
  Eigen::Vector3d errors;
  const std::optional<int> slot = next.step->border();
  const int column = slot ? ColumnOf(*slot, message_, border) : 0;
  if (slot) {
    errors = Eigen::Map<const Eigen::Vector3d>(&linearised_[AsIndex(column - kBlocksColumn)]);
    at.border = &errors;
  }
  next.step->Linearize(at, linear);
  if (is_anchor) {
    const std::array<JacobianBlock, 3> blocks{{{0, 6, linear.J_pose.data()},
                                               {kAnchorColumn, 6, linear.J_previous.data()},
                                               {column, 3, linear.J_border.data()}}};
    message_.Add(linear, std::span(blocks).first(slot ? 3 : 2));
  } else {
    const std::array<JacobianBlock, 2> blocks{
        {{0, 6, linear.J_previous.data()}, {column, 3, linear.J_border.data()}}};
    message_.Add(linear, std::span(blocks).first(slot ? 2 : 1));
    interior_.push_back(
        EliminateHead(message_, LinkOf(linear, slot ? std::optional(column - 6) : std::nullopt)));
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
  std::vector<double> change(6 + linearised_.size());
  for (int i = 0; i < 6; ++i)
    change[AsIndex(i)] = x_anchor(i) - x_anchor_(i);
  for (std::size_t b = 0; b < slots_.size(); ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      change[6 + 3 * b + i] = border[AsIndex(3 * slots_[b]) + i] - linearised_[3 * b + i];
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
    if (status[AsIndex(slots_[b])].kind != BorderKind::kLandmark) continue;
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = AsIndex(3 * slots_[b] + i);
      const double off = border[k] - linearised_[3 * b + AsIndex(i)];
      moved.distance =
          std::max({moved.distance, std::abs(off - first(i)), std::abs(off - last(i))});
    }
  }
  return moved;
}

}  // namespace limpet
