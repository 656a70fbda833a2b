// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

std::string ReasonOf(const std::vector<int>& held) {
  constexpr std::array<const char*, 6> kNames{"x", "y", "z", "yaw", "pitch", "roll"};
  std::string reason;
  for (const int i : held) {
    reason += reason.empty() ? "not observed and held: " : ", ";
    reason += kNames[AsIndex(i)];
  }
  return reason;
}

}  // namespace

int ArrowSmoother::AddNode(const NavVector& x, std::optional<Term> step) {
  LIMPET_REQUIRE(!step || step->landmark() < 0 || to_be_closed_.count(step->landmark()) == 0,
                 "a step does not depend on errors that are closed");
  return graph_.AddNode(x, std::move(step));
}

TermId ArrowSmoother::AddTerm(int node, Term term) {
  LIMPET_REQUIRE(to_be_closed_.count(term.landmark()) == 0, "nor does a term of a node");
  MarkDirty(node);
  if (term.landmark() >= 0) {
    LeafRange& range = seen_from_[AsIndex(term.landmark())];
    const int leaf = node / ArrowLeaf::kNodes, before = std::max(node - 1, 0) / ArrowLeaf::kNodes;
    range = range.last < 0 ? LeafRange{before, leaf}
                           : LeafRange{std::min(range.first, before), std::max(range.last, leaf)};
  }
  return graph_.AddTerm(node, std::move(term));
}

void ArrowSmoother::RemoveTerm(const TermId& id) {
  MarkDirty(id.node);
  graph_.RemoveTerm(id);
}

int ArrowSmoother::AddBlock(const Eigen::Vector3d& p, bool is_landmark) {
  const int slot = graph_.AddLandmark(p);
  is_landmark_.resize(AsIndex(graph_.slot_count()), true);
  seen_from_.resize(is_landmark_.size());
  seen_from_[AsIndex(slot)] = {};
  is_landmark_[AsIndex(slot)] = is_landmark;
  is_closed_.resize(is_landmark_.size());
  is_solved_.resize(is_landmark_.size());
  is_solved_[AsIndex(slot)] = false;
  border_.resize(AsIndex(3 * graph_.slot_count()), 0.0);
  tree_.origin.border.resize(border_.size(), 0.0);
  border_change_.resize(border_.size(), 0.0);
  sweep_.border.resize(border_.size(), 0.0);
  sweep_.moved.resize(is_landmark_.size());
  for (int i = 0; i < 3; ++i) {
    border_[AsIndex(3 * slot + i)] = tree_.origin.border[AsIndex(3 * slot + i)] = p(i);
    border_change_[AsIndex(3 * slot + i)] = 0.0;
    sweep_.border[AsIndex(3 * slot + i)] = p(i);
  }
  prior_is_old_ = true;
  return slot;
}

int ArrowSmoother::AddLandmark(const Eigen::Vector3d& p) { return AddBlock(p, true); }

int ArrowSmoother::AddErrors(const Eigen::Vector3d& start) { return AddBlock(start, false); }

void ArrowSmoother::CloseErrors(int block) {
  LIMPET_REQUIRE(!is_landmark_[AsIndex(block)], "landmarks stay");
  to_be_closed_.try_emplace(block, graph_.node_count() - 1);
}

void ArrowSmoother::RemoveLandmark(int landmark) {
  for (const int node : graph_.landmark(landmark).nodes) {
    MarkDirty(node);
  }
  graph_.RemoveLandmark(landmark);
  // Leaves and tree still speak of the block: nothing else may take its place before they do not.
  graph_.landmark(landmark).is_reserved = true;
  prior_is_old_ = true;
}

void ArrowSmoother::AddLandmarkTerm(int landmark, Term term) {
  graph_.AddLandmarkTerm(landmark, std::move(term));
  prior_is_old_ = true;
}

void ArrowSmoother::SetJointPrior(std::optional<JointPrior> prior) {
  graph_.SetJointPrior(std::move(prior));
  prior_is_old_ = true;
}

void ArrowSmoother::Untie(int landmark) {
  std::erase_if(graph_.landmark(landmark).terms,
                [](const Term& term) { return term.second() >= 0; });
  prior_is_old_ = true;
}

bool ArrowSmoother::HasCaughtUp(int landmark) const {
  const LeafRange& range = seen_from_[AsIndex(landmark)];
  const auto stale = stale_.lower_bound(range.first);
  return (stale == stale_.end() || *stale > range.last) && !open_is_dirty_;
}

void ArrowSmoother::MarkDirty(int node) {
  if (!has_begun_ || node >= open_.head()) {
    return;
  }
  if (node >= open_.anchor()) {
    open_is_dirty_ = true;
    return;
  }
  dirty_.insert(node / ArrowLeaf::kNodes);
  stale_.insert(node / ArrowLeaf::kNodes);
}

void ArrowSmoother::Begin() {
  has_begun_ = true;
  open_ = ArrowLeaf(0, graph_.node(0).x);
  tree_.origin.anchors.assign(1, graph_.node(0).x);
  anchors_.assign(1, graph_.node(0).x);
  solved_at_.assign(1, -1);
}

void ArrowSmoother::CloseLeaf() {
  const int anchor = open_.head(), leaf = tree_.size();
  for (const int slot : open_.slots()) {
    if (is_landmark_[AsIndex(slot)]) continue;
    LeafRange& range = seen_from_[AsIndex(slot)];
    range = range.last < 0 ? LeafRange{leaf, leaf} : LeafRange{range.first, leaf};
  }
  CloseBlocks();
  sweep_.anchors.push_back(anchors_.back());
  sweep_.visit.insert(leaf);
  sweep_.is_due = true;
  tree_.origin.anchors.push_back(graph_.node(anchor).x);
  anchors_.push_back(graph_.node(anchor).x);
  solved_at_.push_back(-1);
  tree_.Append(std::move(open_));
  open_ = ArrowLeaf(anchor, graph_.node(anchor).x);
  prior_is_old_ = true;
}

void ArrowSmoother::CloseBlocks() {
  for (const auto& [slot, node] : to_be_closed_) {
    if (IsClosed(slot) || node >= open_.head() || seen_from_[AsIndex(slot)].last < 0) continue;
    // One that another in the border still speaks of waits for it.
    bool is_named = false;
    for (int other = 0; other < graph_.slot_count(); ++other) {
      for (const Term& term : graph_.landmark(other).terms)
        is_named = is_named || (!IsClosed(other) && term.second() == slot);
    }
    if (is_named) continue;
    is_closed_[AsIndex(slot)] = true;
    tree_.Close(Closed(slot));
  }
}

ClosedBlock ArrowSmoother::Closed(int slot) const {
  ClosedBlock block{.slot = slot,
                    .first = seen_from_[AsIndex(slot)].first,
                    .last = seen_from_[AsIndex(slot)].last,
                    .terms = {}};
  for (const Term& term : graph_.landmark(slot).terms) {
    ClosedBlock::OwnTerm& own = block.terms.emplace_back();
    own.second = term.second();
    LinearizeBorderTerm(slot, term, own.linear);
  }
  // What speaks of it must be eliminated before it.
  for (const ClosedBlock& other : tree_.closed()) {
    const auto names_it = [slot](const auto& term) { return term.second == slot; };
    if (std::ranges::any_of(other.terms, names_it))
      block.first = std::min(block.first, other.first);
  }
  return block;
}

void ArrowSmoother::ExtendToEnd() {
  if (open_is_dirty_) {
    RebuildOpenLeaf();
  }
  while (open_.head() < graph_.node_count() - 1) {
    open_.Extend(graph_, border_);
    if (open_.head() - open_.anchor() == ArrowLeaf::kNodes) CloseLeaf();
  }
}

void ArrowSmoother::RebuildOpenLeaf() {
  const int head = open_.head();
  open_ = ArrowLeaf(open_.anchor(), open_.x_anchor());
  while (open_.head() < head)
    open_.Extend(graph_, border_);
  open_is_dirty_ = false;
}

void ArrowSmoother::RebuildLeaf(int leaf) {
  const std::vector<NavVector> estimates = LeafEstimates(leaf);
  for (int i = 0; i <= ArrowLeaf::kNodes; ++i)
    graph_.node(leaf * ArrowLeaf::kNodes + i).x = estimates[AsIndex(i)];
  ArrowLeaf rebuilt(leaf * ArrowLeaf::kNodes, estimates.front());
  for (int i = 0; i < ArrowLeaf::kNodes; ++i)
    rebuilt.Extend(graph_, border_);
  tree_.Replace(leaf, std::move(rebuilt));
  stale_.insert(leaf);
  dirty_.erase(leaf);
  estimated_leaf_ = -1;
}

void ArrowSmoother::LinearizeBorderTerm(int slot, const Term& term, LinearTerm& linear) const {
  const auto place = [this](int s) {
    return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(&border_[AsIndex(3 * s)]));
  };
  const auto change = [&](int s) -> Eigen::Vector3d {
    return place(s) - Eigen::Map<const Eigen::Vector3d>(&tree_.origin.border[AsIndex(3 * s)]);
  };
  const int second = term.second();
  const Eigen::Vector3d p = place(slot), q = second < 0 ? p : place(second);
  term.Linearize({.landmark = &p, .second = &q}, linear);
  linear.r.head(linear.rows) -= linear.J_landmark.topRows(linear.rows) * change(slot);
  if (second >= 0)
    linear.r.head(linear.rows) -= linear.J_second.topRows(linear.rows) * change(second);
}

void ArrowSmoother::SetPrior() {
  // The tree's blocks, then those that no closed leaf touches.
  std::vector<int> slots = tree_.whole().slots, places(AsIndex(graph_.slot_count()), -1);
  for (std::size_t i = 0; i < slots.size(); ++i)
    places[AsIndex(slots[i])] = static_cast<int>(i);
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    if (IsClosed(slot) || places[AsIndex(slot)] >= 0) continue;
    places[AsIndex(slot)] = static_cast<int>(slots.size());
    slots.push_back(slot);
  }
  ArrowMessage message = tree_.whole().message;
  message.GrowBorder(3 * static_cast<int>(slots.size()));
  LinearTerm linear;
  for (const int slot : slots) {
    for (const Term& term : graph_.landmark(slot).terms) {
      LinearizeBorderTerm(slot, term, linear);
      const int second = term.second();
      std::array<JacobianBlock, 2> blocks{
          {{6 + 3 * places[AsIndex(slot)], 3, linear.J_landmark.data()}, {}}};
      if (second >= 0) blocks[1] = {6 + 3 * places[AsIndex(second)], 3, linear.J_second.data()};
      message.Add(linear, std::span(blocks).first(second >= 0 ? 2 : 1));
    }
  }
  AddJointPrior(message, places);
  root_.SetPrior(message, slots, tree_.origin.anchors.back(), tree_.origin.border);
  prior_is_old_ = false;
}

void ArrowSmoother::AddJointPrior(ArrowMessage& message, const std::vector<int>& places) const {
  const std::optional<JointPrior>& prior = graph_.joint_prior();
  if (!prior) {
    return;
  }
  // Linear, so it is exact wherever the border is linearised.
  Eigen::VectorXd off = -prior->mean();
  std::vector<int> columns;
  for (const int slot : prior->slots()) {
    for (int i = 0; i < 3; ++i) {
      off(static_cast<Eigen::Index>(columns.size())) += tree_.origin.border[AsIndex(3 * slot + i)];
      columns.push_back(6 + 3 * places[AsIndex(slot)] + i);
    }
  }
  const Eigen::MatrixXd& information = prior->information();
  const Eigen::VectorXd pull = information * off;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    message.g[AsIndex(columns[j])] -= pull(static_cast<Eigen::Index>(j));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] < columns[j]) continue;  // the message keeps its lower triangle
      message.at(columns[i], columns[j]) +=
          information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
}

void ArrowSmoother::SolveRoot(SolveReport& report, int relinearizations) {
  for (int round = 0;; ++round) {
    ++report.iterations;
    const ArrowMessage message = open_.WithHeadTerms(graph_, border_);
    if (prior_is_old_) SetPrior();
    root_.Solve(open_, message);
    for (std::size_t i = 0; i < root_.border().size(); ++i) {
      const std::size_t at = AsIndex(3 * root_.slots()[i / 3]) + i % 3;
      border_[at] = root_.border()[i];
      border_change_[at] = border_[at] - tree_.origin.border[at];
    }
    is_solved_.assign(is_solved_.size(), true);
    anchors_.back() = root_.anchor();
    solved_at_.back() = ++solve_;
    estimated_leaf_ = -1;
    if (round >= relinearizations || !IsStrained(open_, root_.anchor(), root_.head())) {
      return;
    }
    const int last = tree_.size();
    const std::vector<NavVector> estimates = LeafEstimates(last);
    const int anchor = open_.anchor();
    for (int i = 0; i <= open_.head() - anchor; ++i)
      graph_.node(anchor + i).x = estimates[AsIndex(i)];
    open_ = ArrowLeaf(anchor, estimates.front());
    while (open_.head() < graph_.node_count() - 1)
      open_.Extend(graph_, border_);
  }
}

bool ArrowSmoother::IsStrained(const ArrowLeaf& leaf, const NavVector& x_anchor,
                               const NavVector& x_head) const {
  const ArrowLeaf::Strain strain = leaf.StrainAt(x_anchor, x_head, border_, is_landmark_);
  return strain.angle > params_.relinearize_angle || strain.distance > params_.relinearize_distance;
}

SolveReport ArrowSmoother::Update() {
  SolveReport report;
  if (graph_.node_count() == 0) {
    return report;
  }
  if (!has_begun_) Begin();
  KeepUp(report);
  ExtendToEnd();
  SolveRoot(report, params_.rounds_per_update);
  Scan();
  report.has_converged = IsUpToDate();
  report.reason = ReasonOf(root_.held());
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    ChainLandmark& block = graph_.landmark(slot);
    block.is_reserved = block.is_reserved && !HasCaughtUp(slot);
  }
  return report;
}

}  // namespace limpet
