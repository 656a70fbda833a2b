// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

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
  return graph_.AddNode(x, std::move(step));
}

TermId ArrowSmoother::AddTerm(int node, Term term) {
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
  is_solved_.resize(is_landmark_.size());
  is_solved_[AsIndex(slot)] = false;
  border_.resize(AsIndex(3 * graph_.slot_count()), 0.0);
  origin_.border.resize(border_.size(), 0.0);
  border_change_.resize(border_.size(), 0.0);
  sweep_.border.resize(border_.size(), 0.0);
  for (int i = 0; i < 3; ++i) {
    border_[AsIndex(3 * slot + i)] = origin_.border[AsIndex(3 * slot + i)] = p(i);
    border_change_[AsIndex(3 * slot + i)] = 0.0;
    sweep_.border[AsIndex(3 * slot + i)] = p(i);
  }
  prior_is_old_ = true;
  return slot;
}

int ArrowSmoother::AddLandmark(const Eigen::Vector3d& p) { return AddBlock(p, true); }

int ArrowSmoother::AddErrors(const Eigen::Vector3d& start) { return AddBlock(start, false); }

void ArrowSmoother::RemoveLandmark(int landmark) {
  for (const int node : graph_.landmark(landmark).nodes) {
    MarkDirty(node);
  }
  graph_.RemoveLandmark(landmark);
  // Leaves and trunk still speak of the block: nothing else may take its place before they do not.
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
  origin_.anchors.assign(1, graph_.node(0).x);
  anchors_.assign(1, graph_.node(0).x);
}

void ArrowSmoother::CloseLeaf() {
  const int anchor = open_.head();
  origin_.anchors.push_back(graph_.node(anchor).x);
  anchors_.push_back(graph_.node(anchor).x);
  sweep_.anchors.push_back(anchors_[leaves_.size()]);
  sweep_.due_from = std::min(sweep_.due_from, static_cast<int>(leaves_.size()));
  leaves_.push_back(std::move(open_));
  versions_.push_back(0);
  trunk_.Append(leaves_.back(), origin_);
  open_ = ArrowLeaf(anchor, graph_.node(anchor).x);
  prior_is_old_ = true;
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
  leaves_[AsIndex(leaf)] = std::move(rebuilt);
  ++versions_[AsIndex(leaf)];
  stale_.insert(leaf);
  dirty_.erase(leaf);
  estimated_leaf_ = -1;
}

void ArrowSmoother::SetPrior() {
  ArrowMessage message = trunk_.message();
  message.GrowBorder(3 * graph_.slot_count());
  LinearTerm linear;
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    for (const Term& term : graph_.landmark(slot).terms) {
      const auto place = [this](int s) {
        return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(&border_[AsIndex(3 * s)]));
      };
      const auto change = [&](int s) -> Eigen::Vector3d {
        return place(s) - Eigen::Map<const Eigen::Vector3d>(&origin_.border[AsIndex(3 * s)]);
      };
      const int second = term.second();
      const Eigen::Vector3d p = place(slot), q = second < 0 ? p : place(second);
      term.Linearize({.landmark = &p, .second = &q}, linear);
      // Changes count from the origin.
      linear.r.head(linear.rows) -= linear.J_landmark.topRows(linear.rows) * change(slot);
      std::array<JacobianBlock, 2> blocks{{{6 + 3 * slot, 3, linear.J_landmark.data()}, {}}};
      if (second >= 0) {
        linear.r.head(linear.rows) -= linear.J_second.topRows(linear.rows) * change(second);
        blocks[1] = {6 + 3 * second, 3, linear.J_second.data()};
      }
      message.Add(linear, std::span(blocks).first(second >= 0 ? 2 : 1));
    }
  }
  AddJointPrior(message);
  root_.SetPrior(message, origin_.anchors.back(), origin_.border);
  prior_is_old_ = false;
}

void ArrowSmoother::AddJointPrior(ArrowMessage& message) const {
  const std::optional<JointPrior>& prior = graph_.joint_prior();
  if (!prior) {
    return;
  }
  // Linear, so it is exact wherever the border is linearised.
  Eigen::VectorXd off = -prior->mean();
  std::vector<int> columns;
  for (const int slot : prior->slots()) {
    for (int i = 0; i < 3; ++i) {
      off(static_cast<Eigen::Index>(columns.size())) += origin_.border[AsIndex(3 * slot + i)];
      columns.push_back(6 + 3 * slot + i);
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
    border_ = root_.border();
    is_solved_.assign(is_solved_.size(), true);
    border_change_.resize(border_.size());
    for (std::size_t i = 0; i < border_.size(); ++i) {
      border_change_[i] = border_[i] - origin_.border[i];
    }
    anchors_.back() = root_.anchor();
    solved_from_ = static_cast<int>(anchors_.size()) - 1;
    estimated_leaf_ = -1;
    if (round >= relinearizations || !IsStrained(open_, root_.anchor(), root_.head())) {
      return;
    }
    const int last = static_cast<int>(leaves_.size());
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

NavVector ArrowSmoother::PoseAt(int node) const {
  if (!has_begun_ || node > open_.head()) {
    return graph_.node(node).x;
  }
  const int leaf = std::min(node / ArrowLeaf::kNodes, static_cast<int>(leaves_.size()));
  return LeafEstimates(leaf)[AsIndex(node - leaf * ArrowLeaf::kNodes)];
}

Eigen::Vector3d ArrowSmoother::LandmarkAt(int landmark) const {
  return Eigen::Map<const Eigen::Vector3d>(&border_[AsIndex(3 * landmark)]);
}

JointCovariance ArrowSmoother::Covariance(const std::vector<int>& landmarks) const {
  constexpr double kUnknown = 1e8;  // [m^2] of a landmark that no update has seen yet
  std::vector<int> solved;
  std::vector<Eigen::Index> rows{0, 1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (!is_solved_[AsIndex(landmarks[i])]) continue;
    solved.push_back(landmarks[i]);
    for (std::size_t k = 0; k < 3; ++k)
      rows.push_back(static_cast<Eigen::Index>(6 + 3 * i + k));
  }
  const JointCovariance known = root_.Covariance(solved);
  if (solved.size() == landmarks.size()) {
    return known;
  }
  const auto n = static_cast<Eigen::Index>(6 + 3 * landmarks.size());
  JointCovariance joint = kUnknown * JointCovariance::Identity(n, n);
  joint(rows, rows) = known;
  return joint;
}

NavVector ArrowSmoother::AnchorFrom(int anchor, const NavVector& next) const {
  return origin_.anchors[AsIndex(anchor)] +
         BackSubstitute(trunk_.conditional(anchor), next - origin_.anchors[AsIndex(anchor + 1)],
                        border_change_.data());
}

void ArrowSmoother::EnsureAnchors(int anchor) const {
  for (; solved_from_ > anchor; --solved_from_) {
    anchors_[AsIndex(solved_from_ - 1)] =
        AnchorFrom(solved_from_ - 1, anchors_[AsIndex(solved_from_)]);
  }
}

const std::vector<NavVector>& ArrowSmoother::LeafEstimates(int leaf) const {
  if (estimated_leaf_ == leaf) {
    return leaf_estimates_;
  }
  EnsureAnchors(leaf);
  const bool is_open = leaf == static_cast<int>(leaves_.size());
  const ArrowLeaf& of = is_open ? open_ : leaves_[AsIndex(leaf)];
  const NavVector last = is_open ? root_.head() : anchors_[AsIndex(leaf + 1)];
  leaf_estimates_.resize(AsIndex(of.head() - of.anchor() + 1));
  leaf_estimates_.back() = last;
  leaf_estimates_.front() = anchors_[AsIndex(leaf)];
  of.BackSubstituteInterior(
      graph_, anchors_[AsIndex(leaf)], last, border_,
      [&](int node, const NavVector& x) { leaf_estimates_[AsIndex(node - of.anchor())] = x; });
  estimated_leaf_ = leaf;
  return leaf_estimates_;
}

}  // namespace limpet
