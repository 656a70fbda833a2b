// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_tree.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>

namespace limpet {

bool ArrowTree::Exists(const Place& place) const {
  return place.first < static_cast<int>(levels_.size()) &&
         place.second < static_cast<int>(levels_[AsIndex(place.first)].size());
}

ArrowStretch ArrowTree::JoinAt(const Place& place) const {
  const auto [level, number] = place;
  if (level == 1) {
    return Join(ArrowStretch::Of(leaf(2 * number), 2 * number, origin),
                ArrowStretch::Of(leaf(2 * number + 1), 2 * number + 1, origin), closed_);
  }
  const std::vector<ArrowStretch>& below = levels_[AsIndex(level - 1)];
  return Join(below[AsIndex(2 * number)], below[AsIndex(2 * number + 1)], closed_);
}

ArrowStretch ArrowTree::JoinWithTree(const ArrowStretch& left, int leaves) const {
  if (leaves == 1) {
    return Join(left, ArrowStretch::Of(leaf(left.end), left.end, origin), closed_);
  }
  const auto level = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(leaves)));
  return Join(left, levels_[level][AsIndex(left.end / leaves)], closed_);
}

int ArrowTree::TreeAt(int first) const {
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(size() - first)));
}

int ArrowTree::SpineOf(int leaf) const {
  const auto part = std::ranges::upper_bound(spine_, leaf, {}, &ArrowStretch::end);
  return static_cast<int>(part - spine_.begin());
}

std::vector<const ArrowStretch*> ArrowTree::PathTo(int leaf) const {
  std::vector<const ArrowStretch*> path;
  const int part = SpineOf(leaf);
  for (int i = static_cast<int>(spine_.size()) - 1; i >= part; --i)
    path.push_back(&spine_[AsIndex(i)]);
  int level = std::countr_zero(static_cast<unsigned>(TreeAt(Before(spine_, part).end)));
  for (; level > 0; --level)
    path.push_back(&levels_[AsIndex(level)][AsIndex(leaf >> level)]);
  return path;
}

void ArrowTree::Append(ArrowLeaf leaf) {
  leaves_.push_back(std::move(leaf));
  int level = 1;
  for (; size() % (1 << level) == 0; ++level) {
    if (static_cast<int>(levels_.size()) == level) levels_.emplace_back();
    levels_[AsIndex(level)].push_back(JoinAt({level, size() / (1 << level) - 1}));
  }
  const int leaves = 1 << (level - 1), before = size() - leaves;
  while (!spine_.empty() && spine_.back().end > before)
    spine_.pop_back();
  const auto part = static_cast<int>(spine_.size());
  spine_.push_back(JoinWithTree(Before(spine_, part), leaves));
  if (!renewal_) return;
  // What is joined anew behind the scenes goes on with the new tree, or this was all of it.
  if (part <= renewal_->from) {
    renewal_.reset();
  } else {
    renewal_->CutAt(part);
  }
}

void ArrowTree::Replace(int number, ArrowLeaf leaf) {
  leaves_[AsIndex(number)] = std::move(leaf);
  int spine_from = std::numeric_limits<int>::max();
  PassOn({0, number}, waiting_, spine_from);
  RenewSpineFrom(spine_from);
}

void ArrowTree::PassOn(const Place& place, std::set<Place>& waiting, int& spine_from) const {
  const Place above{place.first + 1, place.second / 2};
  if (Exists(above)) {
    waiting.insert(above);
  } else {
    spine_from = std::min(spine_from, SpineOf(place.second << place.first));
  }
}

void ArrowTree::RenewSpineFrom(int part) {
  if (part >= static_cast<int>(spine_.size())) return;
  if (!renewal_ || part < renewal_->from) renewal_ = Renewal{.from = part};
  renewal_->CutAt(part);
}

void ArrowTree::RefreshNow(const std::vector<int>& leaves) {
  Rejoins rejoins = NoRejoins();
  for (const int number : leaves)
    PassOn({0, number}, rejoins.places, rejoins.spine_from);
  RejoinNow(std::move(rejoins));
}

void ArrowTree::Reopen(const std::vector<int>& slots) {
  Rejoins rejoins = NoRejoins();
  for (const int slot : slots) {
    const auto block = std::ranges::find(closed_, slot, &ClosedBlock::slot);
    if (block == closed_.end()) continue;
    AddElimination(*block, rejoins);
    closed_.erase(block);
  }
  RejoinNow(std::move(rejoins));
}

void ArrowTree::AddElimination(const ClosedBlock& block, Rejoins& rejoins) const {
  const auto eliminated = [&](const ArrowStretch& stretch) {
    return std::ranges::count(stretch.blocks, block.slot, &ArrowStretch::Block::slot) > 0;
  };
  const int leaf = block.leaves.last, part = SpineOf(leaf);
  const auto levels = std::countr_zero(static_cast<unsigned>(TreeAt(Before(spine_, part).end)));
  for (int level = 1; level <= levels; ++level) {
    const Place place{level, leaf >> level};
    if (!eliminated(levels_[AsIndex(level)][AsIndex(place.second)])) continue;
    rejoins.places.insert(place);
    return;
  }
  for (int i = part; i < static_cast<int>(spine_.size()); ++i) {
    if (!eliminated(spine_[AsIndex(i)])) continue;
    rejoins.spine_from = std::min(rejoins.spine_from, i);
    return;
  }
}

void ArrowTree::RejoinNow(Rejoins rejoins) {
  auto waiting = std::move(rejoins.places);
  int spine_from = rejoins.spine_from;
  while (!waiting.empty()) {
    const Place place = *waiting.begin();
    waiting.erase(waiting.begin());
    waiting_.erase(place);
    levels_[AsIndex(place.first)][AsIndex(place.second)] = JoinAt(place);
    PassOn(place, waiting, spine_from);
  }
  const bool is_all = renewal_ && renewal_->from >= spine_from;
  for (int i = spine_from; i < static_cast<int>(spine_.size()); ++i) {
    const ArrowStretch& before = Before(spine_, i);
    spine_[AsIndex(i)] = JoinWithTree(before, TreeAt(before.end));
  }
  if (is_all) {
    renewal_.reset();
  } else if (renewal_) {
    RenewSpineFrom(spine_from);
  }
}

double ArrowTree::RefreshOne() {
  if (!waiting_.empty()) {
    const Place place = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    ArrowStretch& at = levels_[AsIndex(place.first)][AsIndex(place.second)];
    at = JoinAt(place);
    int spine_from = std::numeric_limits<int>::max();
    PassOn(place, waiting_, spine_from);
    RenewSpineFrom(spine_from);
    return at.Work();
  }
  if (!renewal_) return 0.0;
  std::vector<ArrowStretch>& renewed = renewal_->parts;
  const ArrowStretch& before = renewed.empty() ? Before(spine_, renewal_->from) : renewed.back();
  renewed.push_back(JoinWithTree(before, TreeAt(before.end)));
  const double work = renewed.back().Work();
  if (renewed.back().end == size()) {
    spine_.resize(AsIndex(renewal_->from));
    std::ranges::move(renewed, std::back_inserter(spine_));
    renewal_.reset();
  }
  return work;
}

void ArrowTree::ReplaceAll(std::vector<ArrowLeaf> leaves) {
  leaves_ = std::move(leaves);
  waiting_.clear();
  renewal_.reset();
  for (int level = 1; level < static_cast<int>(levels_.size()); ++level) {
    for (int i = 0; i < static_cast<int>(levels_[AsIndex(level)].size()); ++i)
      levels_[AsIndex(level)][AsIndex(i)] = JoinAt({level, i});
  }
  for (int i = 0; i < static_cast<int>(spine_.size()); ++i) {
    const ArrowStretch& before = Before(spine_, i);
    spine_[AsIndex(i)] = JoinWithTree(before, TreeAt(before.end));
  }
}

}  // namespace limpet
