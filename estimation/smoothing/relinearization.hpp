// SPDX-License-Identifier: MIT
#pragma once

#include <set>

#include "estimation/smoothing/arrow_estimates.hpp"
#include "estimation/smoothing/moved_leaf_search.hpp"

namespace limpet {

/// Full leaves that are to be linearised anew: the newest at once, those further back so many
/// multiply-adds per update, counted so that equal input gives equal bits. The root goes on with
/// the old versions until all joins of the tree know the new ones.
class Relinearization {
 public:
  /// What an update did.
  struct Progress {
    bool has_new_tree = false;  ///< the root has to take the tree up again
    int eliminated_nodes = 0;
  };
  explicit Relinearization(double work_per_update) : work_per_update_(work_per_update) {}

  void Add(int leaf) {
    dirty_.insert(leaf);
    stale_.insert(leaf);
  }
  /// All leaves have been done at once.
  void Clear();
  [[nodiscard]] Progress Continue(ArrowChain& chain, ArrowEstimates& estimates,
                                  MovedLeafSearch& search);
  [[nodiscard]] bool is_up_to_date() const { return stale_.empty(); }
  /// True if the root knows all these leaves in their newest version.
  [[nodiscard]] bool IsUpToDate(const LeafRange& leaves) const;

 private:
  enum class Stage { kIdle, kLeaves, kJoins };
  void RelinearizeNewest(int from, ArrowChain& chain, ArrowEstimates& estimates,
                         MovedLeafSearch& search, Progress& progress);
  void RelinearizeInBackground(ArrowChain& chain, ArrowEstimates& estimates,
                               MovedLeafSearch& search, Progress& progress);
  void Relinearize(int leaf, ArrowChain& chain, ArrowEstimates& estimates);

  double work_per_update_;
  double work_left_ = 0.0;  ///< of this update's share; below zero, owed
  Stage stage_ = Stage::kIdle;
  std::set<int> dirty_;  ///< leaves to be linearised anew
  std::set<int> stale_;  ///< leaves that the root knows in an old version
};

}  // namespace limpet
