// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_chain.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "estimation/smoothing/border_terms.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr int kIdleLeaves = 2;  // after which what is not needed may rest

}  // namespace

int ArrowChain::AddNode(const NavVector& x, std::optional<Term> step) {
  LIMPET_REQUIRE(!step || !HaveLeftBorder(step->slots()),
                 "a step does not depend on sensor errors that are closed");
  return graph_.AddNode(x, std::move(step));
}

TermId ArrowChain::AddTerm(int node, Term term) {
  LIMPET_REQUIRE(!HaveLeftBorder(term.slots()),
                 "a term does not depend on sensor errors that are closed");
  for (const int slot : term.slots()) {
    std::optional<LeafRange>& range = status_[AsIndex(slot)].leaves;
    const int leaf = node / ArrowLeaf::kNodes, before = std::max(node - 1, 0) / ArrowLeaf::kNodes;
    range = range ? LeafRange{std::min(range->first, before), std::max(range->last, leaf)}
                  : LeafRange{before, leaf};
  }
  Need(term.slots());
  return graph_.AddTerm(node, std::move(term));
}

int ArrowChain::AddBorderVariable(const Eigen::Vector3d& start, BorderKind kind) {
  const int slot = graph_.AddBorderVariable(start);
  status_.resize(AsIndex(graph_.slot_count()));
  status_[AsIndex(slot)] = {};
  status_[AsIndex(slot)].kind = kind;
  status_[AsIndex(slot)].needed_leaf = tree_.size();
  tree_.origin.border.resize(AsIndex(3 * graph_.slot_count()), 0.0);
  for (int i = 0; i < 3; ++i)
    tree_.origin.border[AsIndex(3 * slot + i)] = start(i);
  return slot;
}

void ArrowChain::Close(int slot) {
  BorderStatus& status = status_[AsIndex(slot)];
  LIMPET_REQUIRE(status.kind == BorderKind::kSensorErrors, "landmarks stay");
  if (status.phase != BorderPhase::kOpen) return;
  status.phase = BorderPhase::kClosing;
  status.last_node = graph_.node_count() - 1;
}

void ArrowChain::Need(std::span<const int> slots) {
  for (const int slot : slots)
    status_[AsIndex(slot)].needed_leaf = tree_.size();
}

std::vector<int> ArrowChain::Resting(std::span<const int> slots) const {
  std::vector<int> resting;
  std::ranges::copy_if(slots, std::back_inserter(resting),
                       [this](int slot) { return IsClosed(slot) && CanRest(status(slot).kind); });
  return resting;
}

void ArrowChain::Wake(const std::vector<int>& slots) {
  for (const int slot : slots)
    status_[AsIndex(slot)].phase = BorderPhase::kOpen;
  Need(slots);
  tree_.Reopen(slots);
}

std::optional<int> ArrowChain::NoteChange(int node) {
  if (!has_begun_ || node >= open_.head()) {
    return std::nullopt;
  }
  if (node >= open_.anchor()) {
    is_open_dirty_ = true;
    return std::nullopt;
  }
  return node / ArrowLeaf::kNodes;
}

void ArrowChain::Begin() {
  has_begun_ = true;
  open_ = ArrowLeaf(0, graph_.node(0).x);
  tree_.origin.anchors.assign(1, graph_.node(0).x);
}

bool ArrowChain::ExtendOpenLeaf(const std::vector<double>& border) {
  open_.Extend(graph_, border);
  if (open_.head() - open_.anchor() < ArrowLeaf::kNodes) return false;
  FileOpenLeaf(border);
  return true;
}

void ArrowChain::FileOpenLeaf(const std::vector<double>& border) {
  const int anchor = open_.head(), leaf = tree_.size();
  for (const int slot : open_.slots()) {
    BorderStatus& status = status_[AsIndex(slot)];
    if (status.kind == BorderKind::kLandmark) continue;
    status.leaves = LeafRange{status.leaves ? status.leaves->first : leaf, leaf};
  }
  CloseWhatIsDue(border);
  RestWhatIsIdle(border);
  tree_.origin.anchors.push_back(graph_.node(anchor).x);
  tree_.Append(std::move(open_));
  open_ = ArrowLeaf(anchor, graph_.node(anchor).x);
}

void ArrowChain::CloseWhatIsDue(const std::vector<double>& border) {
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    BorderStatus& status = status_[AsIndex(slot)];
    const bool is_due = status.phase == BorderPhase::kClosing && status.last_node < open_.head() &&
                        status.leaves.has_value();
    // One that another in the border still has a term on waits for it.
    if (!is_due || IsNamedByOthers(slot)) continue;
    status.phase = BorderPhase::kClosed;
    tree_.Close(ClosedBlockOf(slot, border));
  }
}

void ArrowChain::RestWhatIsIdle(const std::vector<double>& border) {
  const auto is_at_hand = [](const BorderStatus& status) {
    return CanRest(status.kind) && status.phase == BorderPhase::kOpen && status.leaves.has_value();
  };
  int count = 0;
  for (int slot = 0; slot < graph_.slot_count(); ++slot)
    count += graph_.border(slot).is_used && CanRest(status(slot).kind) ? 1 : 0;
  if (count <= most_at_hand_) return;
  const std::vector<bool> is_tied = IsTiedInBorder();
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    BorderStatus& status = status_[AsIndex(slot)];
    const bool is_idle = is_at_hand(status) && graph_.border(slot).is_used &&
                         !is_tied[AsIndex(slot)] && status.leaves->last < tree_.size() &&
                         status.needed_leaf + kIdleLeaves <= tree_.size();
    if (!is_idle) continue;
    status.phase = BorderPhase::kClosed;
    tree_.Close(ClosedBlockOf(slot, border));
  }
}

std::vector<bool> ArrowChain::IsTiedInBorder() const {
  std::vector<bool> is_tied(AsIndex(graph_.slot_count()), false);
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    for (const Term& term : graph_.border(slot).terms) {
      if (term.slots().size() < 2) continue;
      for (const int other : term.slots())
        is_tied[AsIndex(other)] = true;
    }
  }
  if (graph_.joint_prior()) {
    for (const int slot : graph_.joint_prior()->slots())
      is_tied[AsIndex(slot)] = true;
  }
  return is_tied;
}

bool ArrowChain::IsNamedByOthers(int slot) const {
  for (int other = 0; other < graph_.slot_count(); ++other) {
    const auto names_it = [slot](const Term& term) { return term.DependsOn(slot); };
    if (other != slot && !IsClosed(other) &&
        std::ranges::any_of(graph_.border(other).terms, names_it))
      return true;
  }
  return false;
}

ClosedBlock ArrowChain::ClosedBlockOf(int slot, const std::vector<double>& border) const {
  ClosedBlock block{.slot = slot, .leaves = *status(slot).leaves, .terms = {}};
  for (const Term& term : graph_.border(slot).terms) {
    ClosedBlock::OwnTerm& own = block.terms.emplace_back();
    own.slots.assign(term.slots().begin(), term.slots().end());
    LinearizeBorderTerm(term, border, tree_.origin, own.linear);
  }
  // What has a term on it must be eliminated before it.
  for (const ClosedBlock& other : tree_.closed()) {
    const auto names_it = [slot](const auto& own) {
      return std::ranges::count(own.slots, slot) > 0;
    };
    if (std::ranges::any_of(other.terms, names_it))
      block.leaves.first = std::min(block.leaves.first, other.leaves.first);
  }
  return block;
}

void ArrowChain::RebuildOpenLeafIfDirty(const std::vector<double>& border) {
  if (!is_open_dirty_) return;
  const int head = open_.head();
  open_ = ArrowLeaf(open_.anchor(), open_.x_anchor());
  while (open_.head() < head)
    open_.Extend(graph_, border);
  is_open_dirty_ = false;
}

void ArrowChain::RelinearizeOpenLeaf(const std::vector<NavVector>& poses,
                                     const std::vector<double>& border) {
  const int anchor = open_.anchor();
  for (int i = 0; i <= open_.head() - anchor; ++i)
    graph_.node(anchor + i).x = poses[AsIndex(i)];
  open_ = ArrowLeaf(anchor, poses.front());
  while (open_.head() < graph_.node_count() - 1)
    open_.Extend(graph_, border);
}

void ArrowChain::RelinearizeLeaf(int leaf, const std::vector<NavVector>& poses,
                                 const std::vector<double>& border) {
  for (int i = 0; i <= ArrowLeaf::kNodes; ++i)
    graph_.node(leaf * ArrowLeaf::kNodes + i).x = poses[AsIndex(i)];
  ArrowLeaf rebuilt(leaf * ArrowLeaf::kNodes, poses.front());
  for (int i = 0; i < ArrowLeaf::kNodes; ++i)
    rebuilt.Extend(graph_, border);
  tree_.Replace(leaf, std::move(rebuilt));
}

void ArrowChain::RelinearizeAll(const std::vector<double>& border) {
  std::vector<ArrowLeaf> leaves;
  for (int leaf = 0; leaf < tree_.size(); ++leaf) {
    const int anchor = leaf * ArrowLeaf::kNodes;
    ArrowLeaf& rebuilt = leaves.emplace_back(anchor, graph_.node(anchor).x);
    for (int i = 0; i < ArrowLeaf::kNodes; ++i)
      rebuilt.Extend(graph_, border);
  }
  for (ClosedBlock& block : tree_.closed())
    block = ClosedBlockOf(block.slot, border);
  tree_.ReplaceAll(std::move(leaves));
  open_ = ArrowLeaf(open_.anchor(), graph_.node(open_.anchor()).x);
  while (open_.head() < graph_.node_count() - 1)
    open_.Extend(graph_, border);
  is_open_dirty_ = false;
}

int ArrowChain::LeafOf(int node) const { return std::min(node / ArrowLeaf::kNodes, tree_.size()); }

}  // namespace limpet
