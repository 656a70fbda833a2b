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
  if (term.landmark() >= 0) {
    ChainLandmark& seen = landmark(term.landmark());
    LIMPET_REQUIRE(seen.is_used, "a term needs its landmark");
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
  if (found->term.landmark() >= 0) {
    std::vector<int>& seen_by = landmark(found->term.landmark()).nodes;
    seen_by.erase(std::ranges::find(seen_by, id.node));
  }
  terms.erase(found);
}

int ChainGraph::AddLandmark(const Eigen::Vector3d& p) {
  const auto free = std::ranges::find_if(
      landmarks_, [](const ChainLandmark& l) { return !l.is_used && !l.is_reserved; });
  const auto slot = static_cast<int>(free - landmarks_.begin());
  if (free == landmarks_.end()) {
    landmarks_.emplace_back();
  }
  landmark(slot) = {.is_used = true, .is_reserved = false, .p = p, .terms = {}, .nodes = {}};
  return slot;
}

void ChainGraph::RemoveLandmark(int slot) {
  for (const int seen_by : std::exchange(landmark(slot).nodes, {})) {
    std::erase_if(node(seen_by).terms,
                  [slot](const ChainNode::Entry& entry) { return entry.term.landmark() == slot; });
  }
  landmark(slot) = {};
  if (joint_prior_ && std::ranges::count(joint_prior_->slots(), slot) > 0) {
    const bool is_last = joint_prior_->slots().size() == 1;
    joint_prior_ = is_last ? std::nullopt : std::optional(joint_prior_->Without(slot));
  }
}

void ChainGraph::SetJointPrior(std::optional<JointPrior> prior) {
  for (const int slot : prior ? prior->slots() : std::vector<int>()) {
    LIMPET_REQUIRE(landmark(slot).is_used && std::ranges::count(prior->slots(), slot) == 1,
                   "a joint prior names landmarks in use, each once");
  }
  joint_prior_ = std::move(prior);
}

void ChainGraph::AddLandmarkTerm(int slot, Term term) {
  LIMPET_REQUIRE(term.landmark() == slot && landmark(slot).is_used, "a term on its landmark");
  landmark(slot).terms.push_back(std::move(term));
}

int ChainGraph::FirstNodeOf(int slot) const {
  const std::vector<int>& nodes = landmark(slot).nodes;
  return nodes.empty() ? node_count() : nodes.front();
}

void ChainGraph::Linearize(int index, const Term& term, LinearTerm& out) const {
  term.Linearize({.pose = &node(index).x, .landmark = PlaceOf(term.landmark())}, out);
}

void ChainGraph::LinearizeStep(int index, LinearTerm& out) const {
  const Term& step = *node(index).step;
  step.Linearize({.previous = &node(index - 1).x,
                  .pose = &node(index).x,
                  .landmark = PlaceOf(step.landmark())},
                 out);
}

void ChainGraph::LinearizeBorder(const Term& term, LinearTerm& out) const {
  term.Linearize({.landmark = PlaceOf(term.landmark()), .second = PlaceOf(term.second())}, out);
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
  for (const ChainLandmark& seen : landmarks_) {
    for (const Term& term : seen.terms) {
      LinearizeBorder(term, linear);
      cost += linear.cost;
    }
  }
  if (joint_prior_) {
    Eigen::VectorXd places(joint_prior_->mean().size());
    Eigen::Index row = 0;
    for (const int slot : joint_prior_->slots()) {
      places.segment<3>(row) = landmark(slot).p;
      row += 3;
    }
    cost += joint_prior_->Cost(places);
  }
  return cost;
}

}  // namespace limpet
