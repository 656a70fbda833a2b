// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr int kCheckpointEvery = 16;  // nodes

std::size_t At(int i) { return static_cast<std::size_t>(i); }

}  // namespace

int ArrowSmoother::AddNode(const NavVector& x, std::optional<Term> step) {
  const int node = graph_.AddNode(x, std::move(step));
  change_.push_back(NavVector::Zero());
  return node;
}

TermId ArrowSmoother::AddTerm(int node, Term term) {
  MarkDirty(node);
  return graph_.AddTerm(node, std::move(term));
}

void ArrowSmoother::RemoveTerm(const TermId& id) {
  MarkDirty(id.node);
  graph_.RemoveTerm(id);
}

int ArrowSmoother::AddLandmark(const Eigen::Vector3d& p) {
  const int slot = graph_.AddLandmark(p);
  border_change_.resize(std::max(border_change_.size(), At(3 * (slot + 1))), 0.0);
  std::fill_n(border_change_.begin() + 3 * slot, 3, 0.0);
  return slot;
}

void ArrowSmoother::RemoveLandmark(int landmark) {
  MarkDirty(graph_.FirstNodeOf(landmark));
  graph_.RemoveLandmark(landmark);
}

void ArrowSmoother::AddLandmarkTerm(int landmark, Term term) {
  graph_.AddLandmarkTerm(landmark, std::move(term));
}

void ArrowSmoother::MarkDirty(int node) { dirty_from_ = std::min(dirty_from_, node); }

void ArrowSmoother::Rewind(int node) {
  if (node >= head_) {
    return;
  }
  const int checkpoint = node / kCheckpointEvery;
  message_ = checkpoints_[At(checkpoint)];
  head_ = checkpoint * kCheckpointEvery;
}

void ArrowSmoother::RelinearizeFromHead() {
  // The head's own linearisation is part of the step into it, which the message holds.
  for (int i = head_ == 0 ? 0 : head_ + 1; i < graph_.node_count(); ++i) {
    graph_.node(i).x += change_[At(i)];
    change_[At(i)].setZero();
  }
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    if (graph_.landmark(slot).is_used && graph_.FirstNodeOf(slot) >= head_) {
      graph_.landmark(slot).p += LandmarkChange(slot);
      std::fill_n(border_change_.begin() + 3 * slot, 3, 0.0);
    }
  }
}

void ArrowSmoother::EliminateToEnd() {
  LinearTerm linear;
  const int last = graph_.node_count() - 1;
  conditionals_.resize(At(last));
  fresh_from_ = std::min(fresh_from_, head_);
  for (; head_ < last; ++head_) {
    if (head_ % kCheckpointEvery == 0) {
      checkpoints_.resize(At(head_ / kCheckpointEvery) + 1);
      checkpoints_.back() = message_;
    }
    for (const ChainNode::Entry& entry : graph_.node(head_).terms) {
      graph_.Linearize(head_, entry.term, linear);
      message_.AddPoseTerm(linear, entry.term.landmark());
    }
    graph_.LinearizeStep(head_ + 1, linear);
    conditionals_[At(head_)] = EliminateHead(message_, linear);
  }
}

void ArrowSmoother::SolveRoot() {
  ArrowMessage root = message_;
  LinearTerm linear;
  for (const ChainNode::Entry& entry : graph_.node(head_).terms) {
    graph_.Linearize(head_, entry.term, linear);
    root.AddPoseTerm(linear, entry.term.landmark());
  }
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    for (const Term& term : graph_.landmark(slot).terms) {
      term.Linearize({nullptr, nullptr, &graph_.landmark(slot).p}, linear);
      root.AddLandmarkTerm(linear, slot);
    }
  }
  root.GrowBorder(3 * graph_.slot_count());
  root_.Solve(std::move(root));
}

void ArrowSmoother::BackSubstituteAll() {
  change_[At(head_)] = root_.pose();
  border_change_ = root_.border();
  border_in_use_.resize(border_change_.size(), 0.0);
  double border_moved = 0.0;
  for (std::size_t i = 0; i < border_change_.size(); ++i) {
    border_moved = std::max(border_moved, std::abs(border_change_[i] - border_in_use_[i]));
  }
  int i = head_ - 1;
  for (; i >= 0; --i) {
    const NavVector change =
        BackSubstitute(conditionals_[At(i)], change_[At(i + 1)], border_change_);
    const double moved = (change - change_[At(i)]).lpNorm<Eigen::Infinity>();
    change_[At(i)] = change;
    if (i < fresh_from_ && moved < params_.refresh && border_moved < params_.refresh) {
      break;
    }
  }
  if (i < 0) {
    border_in_use_ = border_change_;
  }
  fresh_from_ = head_;
}

Eigen::Vector3d ArrowSmoother::LandmarkChange(int landmark) const {
  const std::size_t first = At(3 * landmark);
  if (border_change_.size() < first + 3) {
    return Eigen::Vector3d::Zero();
  }
  return {border_change_[first], border_change_[first + 1], border_change_[first + 2]};
}

int ArrowSmoother::FirstToRelinearize() const {
  int first = graph_.node_count();
  for (int i = 0; i < graph_.node_count() && i < first; ++i) {
    const NavVector& change = change_[At(i)];
    if (change.head<3>().lpNorm<Eigen::Infinity>() > params_.relinearize_position ||
        change.tail<3>().lpNorm<Eigen::Infinity>() > params_.relinearize_angle) {
      first = std::max(i - 1, 0);
    }
  }
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    if (graph_.landmark(slot).is_used &&
        LandmarkChange(slot).lpNorm<Eigen::Infinity>() > params_.relinearize_landmark) {
      first = std::min(first, graph_.FirstNodeOf(slot));
    }
  }
  return first;
}

void ArrowSmoother::Solve(SolveReport& report) {
  report.eliminated_nodes += graph_.node_count() - 1 - head_;
  ++report.iterations;
  EliminateToEnd();
  SolveRoot();
  BackSubstituteAll();
}

SolveReport ArrowSmoother::Update() {
  SolveReport report;
  if (graph_.node_count() == 0) {
    return report;
  }
  if (dirty_from_ < head_) {
    Rewind(dirty_from_);
    RelinearizeFromHead();
  }
  dirty_from_ = INT32_MAX;
  Solve(report);
  for (int round = 0; round < params_.rounds_per_update; ++round) {
    const int first = FirstToRelinearize();
    report.has_converged = first >= graph_.node_count();
    if (report.has_converged) {
      break;
    }
    Rewind(first);
    RelinearizeFromHead();
    Solve(report);
  }
  report.reason = root_.held().empty() ? "" : "a direction of the root is not observed and held";
  return report;
}

void ArrowSmoother::StepAll(double& cost) {
  const std::vector<NavVector> change = change_;
  const std::vector<double> border = border_change_;
  // Each try moves on from the last one, from the whole step down to a thousandth of it.
  double moved = 0.0;
  for (double share = 1.0; share > 1e-3; share *= 0.5) {
    MoveBy(share - moved, change, border);
    moved = share;
    const double stepped = graph_.Cost();
    if (stepped <= cost * (1.0 + 1e-9)) {
      cost = stepped;
      return;
    }
  }
  MoveBy(-moved, change, border);
}

void ArrowSmoother::MoveBy(double share, const std::vector<NavVector>& change,
                           const std::vector<double>& border) {
  for (int i = 0; i < graph_.node_count(); ++i) {
    graph_.node(i).x += share * change[At(i)];
    change_[At(i)].setZero();
  }
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    if (graph_.landmark(slot).is_used && border.size() >= At(3 * slot + 3)) {
      graph_.landmark(slot).p += share * Eigen::Map<const Eigen::Vector3d>(&border[At(3 * slot)]);
    }
  }
  std::ranges::fill(border_change_, 0.0);
}

SolveReport ArrowSmoother::Converge() {
  SolveReport report;
  if (graph_.node_count() == 0) {
    return report;
  }
  dirty_from_ = INT32_MAX;
  double cost = graph_.Cost();
  for (int round = 0; round < params_.rounds_to_converge && !report.has_converged; ++round) {
    message_ = ArrowMessage();
    head_ = 0;
    Solve(report);
    const double before = cost;
    StepAll(cost);
    report.has_converged = std::abs(before - cost) <= 1e-8 * std::max(cost, 1.0);
  }
  message_ = ArrowMessage();
  head_ = 0;
  Solve(report);
  report.cost = cost;
  report.reason = report.has_converged ? "cost settled" : "no longer falls within the rounds given";
  return report;
}

NavVector ArrowSmoother::PoseAt(int node) const { return graph_.node(node).x + change_[At(node)]; }

Eigen::Vector3d ArrowSmoother::LandmarkAt(int landmark) const {
  return graph_.landmark(landmark).p + LandmarkChange(landmark);
}

JointCovariance ArrowSmoother::Covariance(const std::vector<int>& landmarks) const {
  std::vector<int> rows = {0, 1, 2, 3, 4, 5};
  for (const int landmark : landmarks) {
    for (int i = 0; i < 3; ++i) {
      rows.push_back(6 + 3 * landmark + i);
    }
  }
  const Eigen::MatrixXd& all = root_.covariance();
  const auto n = static_cast<Eigen::Index>(rows.size());
  JointCovariance joint(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      joint(i, j) = all(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
    }
  }
  return joint;
}

NavCovariance ArrowSmoother::PoseCovariance(int node) const {
  // With z = (next, B):  x = L^-T (d + e - W z), e white, so Cov(x, z) = -L^-T W Cov(z).
  Eigen::MatrixXd joint = root_.covariance();
  for (int k = head_ - 1; k >= node; --k) {
    const ArrowConditional& c = conditionals_[At(k)];
    const auto columns = static_cast<Eigen::Index>(c.W.size() / 6);
    const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>> W(c.W.data(), 6, columns);
    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> L(c.L.data());
    const auto Lt = L.transpose().triangularView<Eigen::Upper>();
    const Eigen::MatrixXd across = -Lt.solve(W * joint.topRows(columns));
    const NavCovariance inner =
        NavCovariance::Identity() + W * joint.topLeftCorner(columns, columns) * W.transpose();
    const NavCovariance half = Lt.solve(inner);
    const NavCovariance marginal = Lt.solve(half.transpose());
    joint.topRows(6) = across;
    joint.leftCols(6) = across.transpose();
    joint.topLeftCorner<6, 6>() = marginal;
  }
  return joint.topLeftCorner<6, 6>();
}

}  // namespace limpet
