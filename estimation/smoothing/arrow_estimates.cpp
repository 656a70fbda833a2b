// SPDX-License-Identifier: MIT
// What the smoother estimates: from the root down through the tree, as far as it is asked for.
#include <algorithm>
#include <utility>

#include "estimation/smoothing/arrow_smoother.hpp"

namespace limpet {

NavVector ArrowSmoother::PoseAt(int node) const {
  if (!has_begun_ || node > open_.head()) {
    return graph_.node(node).x;
  }
  const int leaf = std::min(node / ArrowLeaf::kNodes, tree_.size());
  return LeafEstimates(leaf)[AsIndex(node - leaf * ArrowLeaf::kNodes)];
}

Eigen::Vector3d ArrowSmoother::LandmarkAt(int landmark) const {
  if (IsClosed(landmark)) SolveEndsOf(seen_from_[AsIndex(landmark)].last);
  return Eigen::Map<const Eigen::Vector3d>(&border_[AsIndex(3 * landmark)]);
}

JointCovariance ArrowSmoother::Covariance(const std::vector<int>& landmarks) const {
  if (std::ranges::any_of(landmarks, [this](int slot) { return IsClosed(slot); })) {
    return CovarianceOf({open_.head()}, landmarks);
  }
  constexpr double kUnknown = 1e8;  // [m^2] of a landmark that no update has seen yet
  std::vector<int> solved;
  std::vector<Eigen::Index> rows{0, 1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (!is_solved_[AsIndex(landmarks[i])]) continue;
    solved.push_back(landmarks[i]);
    for (std::size_t k = 0; k < 3; ++k)
      rows.push_back(static_cast<Eigen::Index>(6 + 3 * i + k));
  }
  const JointCovariance known = root_.Covariance(solved);
  if (solved.size() == landmarks.size()) {
    return known;
  }
  const auto n = static_cast<Eigen::Index>(6 + 3 * landmarks.size());
  JointCovariance joint = kUnknown * JointCovariance::Identity(n, n);
  joint(rows, rows) = known;
  return joint;
}

void ArrowSmoother::SolveStretch(const ArrowStretch& stretch) const {
  if (std::exchange(solved_at_[AsIndex(stretch.middle)], solve_) == solve_) {
    return;
  }
  std::vector<double> known;  // changes of the begin, then of blocks
  const auto gather = [&](const std::vector<int>& slots) {
    known.clear();
    for (Eigen::Index i = 0; stretch.has_begin && i < 6; ++i) {
      known.push_back(anchors_[AsIndex(stretch.first)](i) -
                      tree_.origin.anchors[AsIndex(stretch.first)](i));
    }
    for (const int slot : slots) {
      const auto from = border_change_.begin() + 3 * slot;
      known.insert(known.end(), from, from + 3);
    }
  };
  const NavVector end = anchors_[AsIndex(stretch.end)] - tree_.origin.anchors[AsIndex(stretch.end)];
  for (auto block = stretch.blocks.rbegin(); block != stretch.blocks.rend(); ++block) {
    gather(block->slots);
    const auto n = static_cast<Eigen::Index>(known.size());
    const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> W(block->W.data(), 3, n + 6);
    Eigen::Vector3d change = block->d - W.leftCols<6>() * end;
    change -= W.rightCols(n) * Eigen::Map<const Eigen::VectorXd>(known.data(), n);
    block->L.transpose().triangularView<Eigen::Upper>().solveInPlace(change);
    for (int i = 0; i < 3; ++i) {
      const std::size_t at = AsIndex(3 * block->slot + i);
      border_change_[at] = change(i);
      border_[at] = tree_.origin.border[at] + change(i);
    }
  }
  gather(stretch.middle_slots);
  anchors_[AsIndex(stretch.middle)] = tree_.origin.anchors[AsIndex(stretch.middle)] +
                                      BackSubstitute(stretch.conditional, end, known.data());
}

void ArrowSmoother::SolveEndsOf(int leaf) const {
  if (leaf >= tree_.size()) return;
  for (const ArrowStretch* stretch : tree_.PathTo(leaf))
    SolveStretch(*stretch);
}

const std::vector<NavVector>& ArrowSmoother::LeafEstimates(int leaf) const {
  if (estimated_leaf_ == leaf) {
    return leaf_estimates_;
  }
  SolveEndsOf(leaf);
  const bool is_open = leaf == tree_.size();
  const ArrowLeaf& of = is_open ? open_ : tree_.leaf(leaf);
  const NavVector last = is_open ? root_.head() : anchors_[AsIndex(leaf + 1)];
  leaf_estimates_.resize(AsIndex(of.head() - of.anchor() + 1));
  leaf_estimates_.back() = last;
  leaf_estimates_.front() = anchors_[AsIndex(leaf)];
  of.BackSubstituteInterior(
      graph_, anchors_[AsIndex(leaf)], last, border_,
      [&](int node, const NavVector& x) { leaf_estimates_[AsIndex(node - of.anchor())] = x; });
  estimated_leaf_ = leaf;
  return leaf_estimates_;
}

}  // namespace limpet
