// SPDX-License-Identifier: MIT
#include "estimation/smoothing/chain_graph.hpp"

#include <algorithm>
#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {

int ChainGraph::AddNode(const NavVector& x, std::optional<Term> step) {
  LIMPET_REQUIRE(nodes_.empty() != step.has_value(), "every node but the first has a step");
  nodes_.push_back({.x = x, .step = std::move(step), .terms = {}});
  return node_count() - 1;
}

TermId ChainGraph::AddTerm(int node_index, Term term) {
  for (const int slot : term.slots()) {
    BorderVariable& seen = border(slot);
    LIMPET_REQUIRE(seen.is_used, "a term needs its border variables");
    seen.nodes.insert(std::ranges::upper_bound(seen.nodes, node_index), node_index);
  }
  node(node_index).terms.push_back({next_serial_, std::move(term)});
  return {node_index, next_serial_++};
}

void ChainGraph::RemoveTerm(const TermId& id) {
  std::vector<ChainNode::Entry>& terms = node(id.node).terms;
  const auto found = std::ranges::find(terms, id.serial, &ChainNode::Entry::serial);
  if (found == terms.end()) {
    return;
  }
  Forget(id.node, found->term.slots());
  terms.erase(found);
}

void ChainGraph::Forget(int node_index, std::span<const int> slots) {
  for (const int slot : slots) {
    std::vector<int>& seen_by = border(slot).nodes;
    seen_by.erase(std::ranges::find(seen_by, node_index));
  }
}

int ChainGraph::AddBorderVariable(const Eigen::Vector3d& start) {
  const auto free = std::ranges::find_if(
      border_, [](const BorderVariable& v) { return !v.is_used && !v.is_reserved; });
  const auto slot = static_cast<int>(free - border_.begin());
  if (free == border_.end()) {
    border_.emplace_back();
  }
  border(slot) = {.is_used = true, .is_reserved = false, .x = start, .terms = {}, .nodes = {}};
  return slot;
}

void ChainGraph::RemoveBorderVariable(int slot) {
  const std::vector<int> seen_by = border(slot).nodes;
  for (const int node_index : seen_by) {
    std::erase_if(node(node_index).terms, [&](const ChainNode::Entry& entry) {
      const bool is_on_it = entry.term.DependsOn(slot);
      if (is_on_it) Forget(node_index, entry.term.slots());
      return is_on_it;
    });
  }
  border(slot) = {};
  if (joint_prior_ && std::ranges::count(joint_prior_->slots(), slot) > 0) {
    const bool is_last = joint_prior_->slots().size() == 1;
    joint_prior_ = is_last ? std::nullopt : std::optional(joint_prior_->Without(slot));
  }
}

void ChainGraph::SetJointPrior(std::optional<JointPrior> prior) {
  for (const int slot : prior ? prior->slots() : std::vector<int>()) {
    LIMPET_REQUIRE(border(slot).is_used && std::ranges::count(prior->slots(), slot) == 1,
                   "a joint prior names landmarks in use, each once");
  }
  joint_prior_ = std::move(prior);
}

void ChainGraph::SetBorderTerms(int slot, std::vector<Term> terms) {
  border(slot).terms.clear();
  for (Term& term : terms)
    AddBorderTerm(slot, std::move(term));
}

void ChainGraph::AddBorderTerm(int slot, Term term) {
  LIMPET_REQUIRE(!term.slots().empty() && term.slots().front() == slot && border(slot).is_used,
                 "a term on its border variable");
  border(slot).terms.push_back(std::move(term));
}

void ChainGraph::Linearize(int index, const Term& term, LinearTerm& out) const {
  term.Linearize({.pose = &node(index).x, .border = PointsOf(term)}, out);
}

void ChainGraph::LinearizeStep(int index, LinearTerm& out) const {
  const Term& step = *node(index).step;
  step.Linearize({.previous = &node(index - 1).x, .pose = &node(index).x, .border = PointsOf(step)},
                 out);
}

void ChainGraph::LinearizeBorder(const Term& term, LinearTerm& out) const {
  term.Linearize({.border = PointsOf(term)}, out);
}

double ChainGraph::Cost() const {
  double cost = 0.0;
  LinearTerm linear;
  for (int i = 0; i < node_count(); ++i) {
    if (i > 0) {
      LinearizeStep(i, linear);
      cost += linear.cost;
    }
    for (const ChainNode::Entry& entry : node(i).terms) {
      Linearize(i, entry.term, linear);
      cost += linear.cost;
    }
  }
  for (const BorderVariable& seen : border_) {
    for (const Term& term : seen.terms) {
      LinearizeBorder(term, linear);
      cost += linear.cost;
    }
  }
  if (joint_prior_) {
    Eigen::VectorXd places(joint_prior_->mean().size());
    Eigen::Index row = 0;
    for (const int slot : joint_prior_->slots()) {
      places.segment<3>(row) = border(slot).x;
      row += 3;
    }
    cost += joint_prior_->Cost(places);
  }
  return cost;
}

}  // namespace limpet
