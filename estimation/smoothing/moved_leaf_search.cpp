// SPDX-License-Identifier: MIT
#include "estimation/smoothing/moved_leaf_search.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr int kLeavesPerUpdate = 64;
constexpr double kMovedShare = 0.2;     // of the thresholds: worth a visit
constexpr int kUpdatesPerWhole = 1024;  // so that no slow drift stays unseen

}  // namespace

void MovedLeafSearch::AddBorderVariable(int slot, const Eigen::Vector3d& start) {
  const std::size_t size = std::max(has_border_moved_.size(), AsIndex(slot + 1));
  has_border_moved_.resize(size);
  border_.resize(3 * size, 0.0);
  for (int i = 0; i < 3; ++i)
    border_[AsIndex(3 * slot + i)] = start(i);
}

void MovedLeafSearch::AddLeaf(const NavVector& anchor) {
  visit_.insert(static_cast<int>(anchors_.size()));
  anchors_.push_back(anchor);
  is_due_ = true;
}

void MovedLeafSearch::Restart(const ArrowChain& chain, const std::vector<double>& border) {
  search_.reset();
  for (int leaf = 0; leaf < chain.tree().size(); ++leaf)
    anchors_[AsIndex(leaf)] = chain.tree().leaf(leaf).x_anchor();
  border_ = border;
}

std::vector<int> MovedLeafSearch::Continue(const ArrowChain& chain,
                                           const ArrowEstimates& estimates) {
  if (!search_) {
    const bool has_moved = NoteMovedLandmarks(chain, estimates);
    if (++updates_since_whole_ < kUpdatesPerWhole && !has_moved && !is_due_) return {};
    Begin(chain.tree().size());
  }
  std::vector<int> moved;
  for (int leaves = 0; leaves < kLeavesPerUpdate && search_->at > 0; ++leaves) {
    const Next next = Advance(chain, estimates);
    if (next.is_leaf) {
      const int leaf = next.anchor;
      visit_.erase(leaf);
      const ArrowLeaf::Ends ends{.anchor = estimates.Anchor(leaf),
                                 .head = estimates.Anchor(leaf + 1)};
      const auto displacement =
          chain.tree().leaf(leaf).DisplacementAt(ends, estimates.border(), chain.border_status());
      if (Exceeds(displacement, thresholds_)) moved.push_back(leaf);
    }
    ComeDownTo(next.anchor, estimates);
  }
  if (search_->at == 0) search_.reset();
  return moved;
}

MovedLeafSearch::Next MovedLeafSearch::Advance(const ArrowChain& chain,
                                               const ArrowEstimates& estimates) {
  const int leaf = search_->at - 1;
  for (const ArrowStretch* stretch : chain.tree().PathTo(leaf)) {
    if (stretch->end == search_->at && IsUnmoved(*stretch, estimates))
      return {.anchor = stretch->first, .is_leaf = false};
    estimates.SolveStretch(*stretch);
    for (const ArrowStretch::Block& block : stretch->blocks)
      NoteIfMoved(block.slot, chain, estimates);
  }
  return {.anchor = leaf, .is_leaf = true};
}

void MovedLeafSearch::Begin(int leaves) {
  is_due_ = false;
  const bool is_whole = updates_since_whole_ >= kUpdatesPerWhole;
  if (is_whole) updates_since_whole_ = 0;
  // The last anchor moves with every observation.
  search_ = Search{.at = leaves, .is_whole = is_whole, .has_at_moved = true};
}

void MovedLeafSearch::ComeDownTo(int anchor, const ArrowEstimates& estimates) {
  search_->at = anchor;
  search_->has_at_moved = HasMoved(anchor, estimates);
  if (search_->has_at_moved) anchors_[AsIndex(anchor)] = estimates.Anchor(anchor);
}

bool MovedLeafSearch::IsUnmoved(const ArrowStretch& stretch,
                                const ArrowEstimates& estimates) const {
  const auto visit = visit_.lower_bound(stretch.first);
  if (search_->is_whole || search_->has_at_moved ||
      (visit != visit_.end() && *visit < stretch.end)) {
    return false;
  }
  // Without a begin, all that it depends on is its end and the border.
  if (stretch.has_begin && HasMoved(stretch.first, estimates)) return false;
  // What rests inside it moves with these alone.
  return std::ranges::none_of(stretch.slots,
                              [this](int slot) { return has_border_moved_[AsIndex(slot)]; });
}

bool MovedLeafSearch::NoteMovedLandmarks(const ArrowChain& chain, const ArrowEstimates& estimates) {
  bool has_any = false;
  has_border_moved_.assign(chain.border_status().size(), false);
  for (std::size_t slot = 0; slot < chain.border_status().size(); ++slot)
    has_any = NoteIfMoved(static_cast<int>(slot), chain, estimates) || has_any;
  return has_any;
}

bool MovedLeafSearch::NoteIfMoved(int slot, const ArrowChain& chain,
                                  const ArrowEstimates& estimates) {
  const Eigen::Map<const Eigen::Vector3d> now(&estimates.border()[AsIndex(3 * slot)]);
  Eigen::Map<Eigen::Vector3d> then(&border_[AsIndex(3 * slot)]);
  const double enough = kMovedShare * thresholds_.distance;
  const bool counts = chain.status(slot).kind != BorderKind::kSensorErrors;
  if (!counts || (now - then).lpNorm<Eigen::Infinity>() <= enough) return false;
  then = now;
  has_border_moved_[AsIndex(slot)] = true;
  return true;
}

bool MovedLeafSearch::HasMoved(int anchor, const ArrowEstimates& estimates) const {
  const NavVector moved = (estimates.Anchor(anchor) - anchors_[AsIndex(anchor)]).cwiseAbs();
  return moved.head<3>().maxCoeff() > kMovedShare * thresholds_.distance ||
         moved.tail<3>().maxCoeff() > kMovedShare * thresholds_.angle;
}

}  // namespace limpet
