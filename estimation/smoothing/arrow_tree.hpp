// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "estimation/smoothing/arrow_stretch.hpp"

namespace limpet {

/// The closed leaves, joined two by two, those again, and so on: a leaf that is linearised anew
/// costs as many joins as the tree is high. The trees of complete pairs, longest first, are joined
/// one after the other to the spine, whose last holds all.
class ArrowTree {
 public:
  [[nodiscard]] int size() const { return static_cast<int>(leaves_.size()); }
  [[nodiscard]] const ArrowLeaf& leaf(int i) const { return leaves_[AsIndex(i)]; }
  /// All leaves, over the last anchor and the blocks that are not closed.
  [[nodiscard]] const ArrowStretch& whole() const {
    return spine_.empty() ? nothing_ : spine_.back();
  }
  /// The stretches that hold the leaf, from the whole down: ends of each are ends or middles of
  /// those before.
  [[nodiscard]] std::vector<const ArrowStretch*> PathTo(int leaf) const;

  /// `leaf` is the one after the last; its end is at the last of the origin's anchors.
  void Append(ArrowLeaf leaf);
  /// Puts a leaf in place of its former version. The tree knows of it once it is refreshed.
  void Replace(int number, ArrowLeaf leaf);
  /// Joins anew at once all that has to do with these leaves.
  void RefreshNow(const std::vector<int>& leaves);
  /// One join of those that replaced leaves ask for; multiply-adds that it took.
  double RefreshOne();
  /// True if all joins know the newest version of all leaves.
  [[nodiscard]] bool is_fresh() const { return waiting_.empty() && !renewal_; }
  /// All leaves in new versions.
  void ReplaceAll(std::vector<ArrowLeaf> leaves);
  /// No leaf to come depends on the block. Takes effect with the next leaf.
  void Close(ClosedBlock block) { closed_.push_back(std::move(block)); }
  /// Takes closed blocks back: leaves to come may depend on them. Joins anew what eliminated them.
  void Reopen(const std::vector<int>& slots);
  [[nodiscard]] std::vector<ClosedBlock>& closed() { return closed_; }
  [[nodiscard]] const std::vector<ClosedBlock>& closed() const { return closed_; }

  ArrowOrigin origin;

 private:
  using Place = std::pair<int, int>;  ///< level from 1 on, number in it
  [[nodiscard]] bool Exists(const Place& place) const;
  [[nodiscard]] ArrowStretch JoinAt(const Place& place) const;
  /// `left` and the tree of so many leaves that follows it.
  [[nodiscard]] ArrowStretch JoinWithTree(const ArrowStretch& left, int leaves) const;
  /// Leaves of the tree that begins at `first`.
  [[nodiscard]] int TreeAt(int first) const;
  /// Part of the spine whose tree holds the leaf.
  [[nodiscard]] int SpineOf(int leaf) const;
  [[nodiscard]] const ArrowStretch& Before(const std::vector<ArrowStretch>& spine, int part) const {
    return part == 0 ? nothing_ : spine[AsIndex(part - 1)];
  }
  /// The spine from a part on, as far as it has been joined anew; it takes the place of the old one
  /// when it is whole.
  struct Renewal {
    int from = 0;
    std::vector<ArrowStretch> parts = {};
    void CutAt(int part) { parts.resize(std::min(parts.size(), AsIndex(part - from))); }
  };
  void RenewSpineFrom(int part);
  /// What is to be joined anew: places in the levels, lowest first, and the spine from a part on.
  struct Rejoins {
    std::set<Place> places;
    int spine_from;
  };
  [[nodiscard]] Rejoins NoRejoins() const {
    return {.places = {}, .spine_from = static_cast<int>(spine_.size())};
  }
  /// Does these and all that depend on them.
  void RejoinNow(Rejoins rejoins);
  /// Adds the lowest stretch that eliminated the block, if any did.
  void AddElimination(const ClosedBlock& block, Rejoins& rejoins) const;
  /// Goes up from what has been joined anew: the place above, or the spine.
  void PassOn(const Place& place, std::set<Place>& waiting, int& spine_from) const;

  std::vector<ArrowLeaf> leaves_;
  std::vector<std::vector<ArrowStretch>> levels_{1};  ///< the first is empty: leaves
  ArrowStretch nothing_ = ArrowStretch::Nothing();
  std::vector<ArrowStretch> spine_;
  std::set<Place> waiting_;  ///< to be joined anew, lowest first
  std::optional<Renewal> renewal_;
  std::vector<ClosedBlock> closed_;
};

}  // namespace limpet
