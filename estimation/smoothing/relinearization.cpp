// SPDX-License-Identifier: MIT
#include "estimation/smoothing/relinearization.hpp"

#include <algorithm>
#include <vector>

namespace limpet {
namespace {

constexpr double kLeafWork = 60000.0;  // multiply-adds of linearising a leaf anew, about
constexpr int kNewestLeaves = 4;       // brought up to date at once

}  // namespace

void Relinearization::Clear() {
  dirty_.clear();
  stale_.clear();
  stage_ = Stage::kIdle;
}

bool Relinearization::IsUpToDate(const LeafRange& leaves) const {
  const auto stale = stale_.lower_bound(leaves.first);
  return stale == stale_.end() || *stale > leaves.last;
}

Relinearization::Progress Relinearization::Continue(ArrowChain& chain, ArrowEstimates& estimates,
                                                    MovedLeafSearch& search) {
  Progress progress;
  // The newest leaves are at hand, and matter most.
  const int newest = std::max(chain.tree().size() - kNewestLeaves, 0);
  if (dirty_.lower_bound(newest) != dirty_.end())
    RelinearizeNewest(newest, chain, estimates, search, progress);
  if (!dirty_.empty() || stage_ != Stage::kIdle)
    RelinearizeInBackground(chain, estimates, search, progress);
  return progress;
}

void Relinearization::Relinearize(int leaf, ArrowChain& chain, ArrowEstimates& estimates) {
  const std::vector<NavVector> poses = estimates.LeafEstimates(leaf);
  chain.RelinearizeLeaf(leaf, poses, estimates.border());
  stale_.insert(leaf);
  dirty_.erase(leaf);
  estimates.ForgetLeafEstimates();
}

void Relinearization::RelinearizeNewest(int from, ArrowChain& chain, ArrowEstimates& estimates,
                                        MovedLeafSearch& search, Progress& progress) {
  const std::vector<int> leaves(dirty_.lower_bound(from), dirty_.end());
  for (const int leaf : leaves)
    Relinearize(leaf, chain, estimates);
  chain.tree().RefreshNow(leaves);
  for (const int leaf : leaves) {
    stale_.erase(leaf);
    search.Visit(leaf);
  }
  search.RequestSearch();
  progress.has_new_tree = true;
  progress.eliminated_nodes += ArrowLeaf::kNodes * static_cast<int>(leaves.size());
}

void Relinearization::RelinearizeInBackground(ArrowChain& chain, ArrowEstimates& estimates,
                                              MovedLeafSearch& search, Progress& progress) {
  // What a step takes beyond one update's share is saved up over several.
  work_left_ = std::min(work_left_, 0.0) + work_per_update_;
  while (work_left_ > 0.0) {
    if (stage_ != Stage::kJoins && !dirty_.empty()) {
      stage_ = Stage::kLeaves;
      const int leaf = *dirty_.begin();
      search.Visit(leaf);
      Relinearize(leaf, chain, estimates);
      work_left_ -= kLeafWork;
      progress.eliminated_nodes += ArrowLeaf::kNodes;
      continue;
    }
    // What a search under way still finds has moved with them, and takes effect with them: half of
    // the chain linearised elsewhere would hold what nothing observes.
    if (stage_ == Stage::kLeaves && search.is_under_way()) return;
    stage_ = Stage::kJoins;
    if (chain.tree().is_fresh()) break;
    work_left_ -= chain.tree().RefreshOne();
    ++progress.eliminated_nodes;
  }
  if (stage_ == Stage::kJoins && chain.tree().is_fresh()) {
    stage_ = Stage::kIdle;
    stale_ = dirty_;
    search.RequestSearch();
    progress.has_new_tree = true;
  }
}

}  // namespace limpet
