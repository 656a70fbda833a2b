// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_estimates.hpp"

#include <utility>

namespace limpet {

void ArrowEstimates::AddBorderVariable(int slot, const Eigen::Vector3d& start) {
  const std::size_t size = AsIndex(chain_->graph().slot_count());
  is_solved_.resize(size);
  is_solved_[AsIndex(slot)] = false;
  border_.resize(3 * size, 0.0);
  border_change_.resize(3 * size, 0.0);
  for (int i = 0; i < 3; ++i) {
    border_[AsIndex(3 * slot + i)] = start(i);
    border_change_[AsIndex(3 * slot + i)] = 0.0;
  }
}

void ArrowEstimates::AddAnchor(const NavVector& x) {
  anchors_.push_back(x);
  solved_at_.push_back(-1);
}

void ArrowEstimates::Take(const ArrowRoot& root) {
  for (std::size_t i = 0; i < root.border().size(); ++i) {
    const std::size_t at = AsIndex(3 * root.slots()[i / 3]) + i % 3;
    border_[at] = root.border()[i];
    border_change_[at] = border_[at] - origin().border[at];
  }
  is_solved_.assign(is_solved_.size(), true);
  anchors_.back() = root.anchor();
  head_ = root.head();
  solved_at_.back() = ++solution_;
  ForgetLeafEstimates();
}

NavVector ArrowEstimates::PoseAt(int node) const {
  if (!chain_->has_begun() || node > chain_->open_leaf().head()) {
    return chain_->graph().node(node).x;
  }
  const int leaf = chain_->LeafOf(node);
  return LeafEstimates(leaf)[AsIndex(node - leaf * ArrowLeaf::kNodes)];
}

Eigen::Vector3d ArrowEstimates::BorderAt(int slot) const {
  if (chain_->IsClosed(slot)) SolveEndsOf(chain_->status(slot).leaves->last);
  return Eigen::Map<const Eigen::Vector3d>(&border_[AsIndex(3 * slot)]);
}

std::vector<double> ArrowEstimates::ChangesOf(const ArrowStretch& stretch,
                                              const std::vector<int>& slots) const {
  std::vector<double> changes;
  for (Eigen::Index i = 0; stretch.has_begin && i < 6; ++i) {
    changes.push_back(anchors_[AsIndex(stretch.first)](i) -
                      origin().anchors[AsIndex(stretch.first)](i));
  }
  for (const int slot : slots) {
    const auto from = border_change_.begin() + 3 * slot;
    changes.insert(changes.end(), from, from + 3);
  }
  return changes;
}

void ArrowEstimates::SolveBlock(const ArrowStretch& stretch, const ArrowStretch::Block& block,
                                const NavVector& end) const {
  const std::vector<double> known = ChangesOf(stretch, block.slots);
  const auto n = static_cast<Eigen::Index>(known.size());
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> W(block.W.data(), 3, n + 6);
  Eigen::Vector3d change = block.d - W.leftCols<6>() * end;
  change -= W.rightCols(n) * Eigen::Map<const Eigen::VectorXd>(known.data(), n);
  block.L.transpose().triangularView<Eigen::Upper>().solveInPlace(change);
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = AsIndex(3 * block.slot + i);
    border_change_[at] = change(i);
    border_[at] = origin().border[at] + change(i);
  }
}

void ArrowEstimates::SolveStretch(const ArrowStretch& stretch) const {
  if (std::exchange(solved_at_[AsIndex(stretch.middle)], solution_) == solution_) {
    return;
  }
  const NavVector end = anchors_[AsIndex(stretch.end)] - origin().anchors[AsIndex(stretch.end)];
  for (auto block = stretch.blocks.rbegin(); block != stretch.blocks.rend(); ++block)
    SolveBlock(stretch, *block, end);
  const std::vector<double> known = ChangesOf(stretch, stretch.middle_slots);
  anchors_[AsIndex(stretch.middle)] = origin().anchors[AsIndex(stretch.middle)] +
                                      BackSubstitute(stretch.conditional, end, known.data());
}

void ArrowEstimates::SolveEndsOf(int leaf) const {
  if (leaf >= chain_->tree().size()) return;
  for (const ArrowStretch* stretch : chain_->tree().PathTo(leaf))
    SolveStretch(*stretch);
}

const std::vector<NavVector>& ArrowEstimates::LeafEstimates(int leaf) const {
  if (estimated_leaf_ == leaf) {
    return leaf_estimates_;
  }
  SolveEndsOf(leaf);
  const bool is_open = leaf == chain_->tree().size();
  const ArrowLeaf& of = is_open ? chain_->open_leaf() : chain_->tree().leaf(leaf);
  const ArrowLeaf::Ends ends{.anchor = anchors_[AsIndex(leaf)],
                             .head = is_open ? head_ : anchors_[AsIndex(leaf + 1)]};
  leaf_estimates_.resize(AsIndex(of.head() - of.anchor() + 1));
  leaf_estimates_.back() = ends.head;
  leaf_estimates_.front() = ends.anchor;
  of.BackSubstituteInterior(chain_->graph(), ends, border_, [&](int node, const NavVector& x) {
    leaf_estimates_[AsIndex(node - of.anchor())] = x;
  });
  estimated_leaf_ = leaf;
  return leaf_estimates_;
}

}  // namespace limpet
