// SPDX-License-Identifier: MIT
// What keeps the smoother's linearisation near its estimate: so much per update, counted in
// multiply-adds, so that equal input gives equal bits.
#include <algorithm>
#include <limits>
#include <utility>

#include "estimation/smoothing/arrow_smoother.hpp"

namespace limpet {
namespace {

constexpr double kLeafWork = 60000.0;  // multiply-adds of linearising a leaf anew, about
constexpr int kLeavesAtHand = 4;       // the newest, brought up to date at once whatever they take
constexpr double kScanShare = 0.08;    // of an update's work, for the search for strained leaves
constexpr double kMovedShare = 0.2;    // of the change that strains a leaf: worth a look
constexpr int kSweepsPerWhole = 64;    // so that nothing creeps away unseen

}  // namespace

void ArrowSmoother::AppendTo(ArrowTrunk& trunk, SolveReport& report) {
  const int leaf = trunk.head();
  if (dirty_.contains(leaf)) {
    RebuildLeaf(leaf);
  }
  trunk.Append(leaves_[AsIndex(leaf)], origin_);
  report.eliminated_nodes += ArrowLeaf::kNodes;
}

void ArrowSmoother::KeepUp(SolveReport& report) {
  if (!stale_.empty()) {
    // The newest leaves are at hand, and matter most.
    const auto leaves = static_cast<int>(params_.work_per_update / WorkPerAnchor());
    const int near = std::max(trunk_.head() - std::max(leaves, kLeavesAtHand), 0);
    const auto first = stale_.lower_bound(near);
    if (first != stale_.end()) KeepUpNow(*first, report);
  }
  if (!stale_.empty() || behind_) KeepUpBehind(report);
}

void ArrowSmoother::KeepUpNow(int from, SolveReport& report) {
  const int end = trunk_.head(), begin = ArrowTrunk::CheckpointBefore(from);
  // Estimates first: the trunk cannot answer while it is cut.
  for (auto leaf = dirty_.lower_bound(begin); leaf != dirty_.end();) {
    RebuildLeaf(*leaf++);
  }
  trunk_.Rewind(begin);
  while (trunk_.head() < end)
    AppendTo(trunk_, report);
  stale_.erase(stale_.lower_bound(begin), stale_.end());
  prior_is_old_ = true;
  sweep_.due_from = std::min(sweep_.due_from, begin);
  solved_from_ = static_cast<int>(anchors_.size()) - 1;
  estimated_leaf_ = -1;
}

void ArrowSmoother::KeepUpBehind(SolveReport& report) {
  if (!behind_) {
    behind_.emplace(trunk_, *stale_.begin());
    behind_versions_.clear();
  }
  // What an anchor takes beyond one update's share is saved up over several.
  work_left_ = std::min(work_left_, 0.0) + params_.work_per_update;
  while (work_left_ > 0.0 && behind_->head() < trunk_.head()) {
    const int leaf = behind_->head();
    work_left_ -= WorkPerAnchor() + (dirty_.contains(leaf) ? kLeafWork : 0.0);
    AppendTo(*behind_, report);
    behind_versions_.push_back(versions_[AsIndex(leaf)]);
  }
  if (behind_->head() < trunk_.head()) {
    return;
  }
  for (std::size_t i = 0; i < behind_versions_.size(); ++i) {
    const int leaf = behind_->first() + static_cast<int>(i);
    if (behind_versions_[i] == versions_[AsIndex(leaf)] && !dirty_.contains(leaf))
      stale_.erase(leaf);
  }
  sweep_.due_from = std::min(sweep_.due_from, behind_->first());
  trunk_.Splice(std::move(*behind_));
  behind_.reset();
  prior_is_old_ = true;
}

void ArrowSmoother::Scan() {
  if (!sweep_.is_on()) {
    NoteMovedLandmarks();
    if (sweep_.due_from == Sweep::kNowhere) return;
    BeginSweep();
  }
  const double per_leaf = 6.0 * (6.0 + 3.0 * graph_.slot_count()) + 200.0;
  for (double work = kScanShare * params_.work_per_update; work > 0.0 && sweep_.at > 0;
       work -= per_leaf) {
    const int leaf = --sweep_.at;
    const NavVector anchor = AnchorFrom(leaf, sweep_.x);
    if (IsStrained(leaves_[AsIndex(leaf)], anchor, sweep_.x)) {
      dirty_.insert(leaf);
      stale_.insert(leaf);
    }
    sweep_.x = anchor;
    if (HasMovedSinceSweep(leaf, anchor)) {
      sweep_.anchors[AsIndex(leaf)] = anchor;
    } else if (leaf < sweep_.floor) {
      sweep_.at = 0;
    }
  }
  if (sweep_.at == 0) sweep_.at = -1;
}

void ArrowSmoother::BeginSweep() {
  sweep_.floor = std::exchange(sweep_.due_from, Sweep::kNowhere);
  if (++sweep_.since_whole >= kSweepsPerWhole) {
    sweep_.since_whole = sweep_.floor = 0;
  }
  sweep_.at = trunk_.head();
  sweep_.x = anchors_.back();
}

void ArrowSmoother::NoteMovedLandmarks() {
  const double enough = kMovedShare * params_.relinearize_distance;
  for (int slot = 0; slot < graph_.slot_count(); ++slot) {
    const Eigen::Map<const Eigen::Vector3d> now(&border_[AsIndex(3 * slot)]);
    Eigen::Map<Eigen::Vector3d> then(&sweep_.border[AsIndex(3 * slot)]);
    if (!is_landmark_[AsIndex(slot)] || (now - then).lpNorm<Eigen::Infinity>() <= enough) continue;
    then = now;
    sweep_.due_from = std::min(sweep_.due_from, seen_from_[AsIndex(slot)].first);
  }
}

bool ArrowSmoother::HasMovedSinceSweep(int leaf, const NavVector& anchor) const {
  const NavVector moved = (anchor - sweep_.anchors[AsIndex(leaf)]).cwiseAbs();
  return moved.head<3>().maxCoeff() > kMovedShare * params_.relinearize_distance ||
         moved.tail<3>().maxCoeff() > kMovedShare * params_.relinearize_angle;
}

void ArrowSmoother::LinearizeAll() {
  trunk_ = ArrowTrunk();
  behind_.reset();
  dirty_.clear();
  stale_.clear();
  sweep_.at = -1;
  for (int leaf = 0; leaf < static_cast<int>(leaves_.size()); ++leaf) {
    ArrowLeaf rebuilt(leaf * ArrowLeaf::kNodes, graph_.node(leaf * ArrowLeaf::kNodes).x);
    for (int i = 0; i < ArrowLeaf::kNodes; ++i)
      rebuilt.Extend(graph_, border_);
    leaves_[AsIndex(leaf)] = std::move(rebuilt);
    ++versions_[AsIndex(leaf)];
    sweep_.anchors[AsIndex(leaf)] = leaves_[AsIndex(leaf)].x_anchor();
    trunk_.Append(leaves_[AsIndex(leaf)], origin_);
  }
  open_ = ArrowLeaf(open_.anchor(), graph_.node(open_.anchor()).x);
  while (open_.head() < graph_.node_count() - 1)
    open_.Extend(graph_, border_);
  open_is_dirty_ = false;
  prior_is_old_ = true;
  sweep_.border = border_;
}

bool ArrowSmoother::StepAll(double& cost, const std::vector<NavVector>& poses,
                            const std::vector<double>& border) {
  std::vector<NavVector> old_poses(poses.size());
  std::vector<Eigen::Vector3d> old_places(AsIndex(graph_.slot_count()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    old_poses[i] = graph_.node(static_cast<int>(i)).x;
  for (std::size_t i = 0; i < old_places.size(); ++i) {
    old_places[i] = graph_.landmark(static_cast<int>(i)).p;
  }
  const double before = cost;
  // From the whole step down to a thousandth of it, then none.
  for (double share = 1.0;; share = share > 1e-3 ? 0.5 * share : 0.0) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      graph_.node(static_cast<int>(i)).x = old_poses[i] + share * (poses[i] - old_poses[i]);
    }
    for (std::size_t i = 0; i < old_places.size(); ++i) {
      const Eigen::Map<const Eigen::Vector3d> place(&border[3 * i]);
      graph_.landmark(static_cast<int>(i)).p = old_places[i] + share * (place - old_places[i]);
      std::copy_n(graph_.landmark(static_cast<int>(i)).p.data(), 3, &border_[3 * i]);
    }
    const double stepped = graph_.Cost();
    if (stepped > before * (1.0 + 1e-9) && share > 0.0) continue;
    cost = stepped;
    if (share < 1.0 || !HasSettled(before, cost)) return false;
    // The whole step changed next to nothing: the linearisation that it came from still holds.
    for (std::size_t i = 0; i < poses.size(); ++i)
      graph_.node(static_cast<int>(i)).x = old_poses[i];
    for (std::size_t i = 0; i < old_places.size(); ++i)
      graph_.landmark(static_cast<int>(i)).p = old_places[i];
    return true;
  }
}

SolveReport ArrowSmoother::Converge() {
  SolveReport report;
  if (graph_.node_count() == 0) {
    return report;
  }
  if (!has_begun_) Begin();
  ExtendToEnd();
  for (int i = 0; i < graph_.slot_count(); ++i)
    graph_.landmark(i).is_reserved = false;
  // All starts from the estimate, wherever each part is linearised.
  double cost = std::numeric_limits<double>::infinity();
  bool is_linearised = false;
  while (report.iterations < params_.rounds_to_converge && !report.has_converged) {
    if (report.iterations > 0) LinearizeAll();
    // No part may move before the step as a whole is found good.
    SolveReport solved;
    SolveRoot(solved, 0);
    std::vector<NavVector> poses(AsIndex(graph_.node_count()));
    for (int i = graph_.node_count() - 1; i >= 0; --i)
      poses[AsIndex(i)] = PoseAt(i);
    const double before = cost;
    is_linearised = StepAll(cost, poses, std::vector<double>(border_));
    ++report.iterations;
    report.eliminated_nodes += graph_.node_count();
    report.has_converged = HasSettled(before, cost);
  }
  if (!is_linearised) {
    LinearizeAll();
    SolveReport solved;
    SolveRoot(solved, 0);
  }
  report.cost = cost;
  report.reason = report.has_converged ? "cost settled" : "no longer falls within the rounds given";
  return report;
}

}  // namespace limpet
