// SPDX-License-Identifier: MIT
// What keeps the smoother's linearisation near its estimate: so much per update, counted in
// multiply-adds, so that equal input gives equal bits.
#include <algorithm>
#include <limits>

#include "estimation/smoothing/arrow_smoother.hpp"

namespace limpet {
namespace {

constexpr double kLeafWork = 60000.0;   // multiply-adds of linearising a leaf anew, about
constexpr int kLeavesAtHand = 4;        // the newest, brought up to date at once
constexpr int kLeavesPerScan = 64;      // of one update's search for strained leaves
constexpr double kMovedShare = 0.2;     // of the change that strains a leaf: worth a look
constexpr int kUpdatesPerWhole = 1024;  // so that nothing creeps away unseen

}  // namespace

void ArrowSmoother::KeepUp(SolveReport& report) {
  // The newest leaves are at hand, and matter most.
  const int near = std::max(tree_.size() - kLeavesAtHand, 0);
  if (dirty_.lower_bound(near) != dirty_.end()) KeepUpNow(near, report);
  if (!dirty_.empty() || job_ != Job::kNone) KeepUpBehind(report);
}

void ArrowSmoother::KeepUpNow(int from, SolveReport& report) {
  const std::vector<int> leaves(dirty_.lower_bound(from), dirty_.end());
  for (const int leaf : leaves)
    RebuildLeaf(leaf);
  tree_.RefreshNow(leaves);
  for (const int leaf : leaves)
    stale_.erase(leaf);
  sweep_.visit.insert(leaves.begin(), leaves.end());
  sweep_.is_due = prior_is_old_ = true;
  report.eliminated_nodes += ArrowLeaf::kNodes * static_cast<int>(leaves.size());
}

void ArrowSmoother::KeepUpBehind(SolveReport& report) {
  // What a step takes beyond one update's share is saved up over several.
  work_left_ = std::min(work_left_, 0.0) + params_.work_per_update;
  while (work_left_ > 0.0) {
    if (job_ != Job::kJoins && !dirty_.empty()) {
      job_ = Job::kLeaves;
      const int leaf = *dirty_.begin();
      sweep_.visit.insert(leaf);
      RebuildLeaf(leaf);
      work_left_ -= kLeafWork;
      report.eliminated_nodes += ArrowLeaf::kNodes;
      continue;
    }
    // What a search under way still finds has moved with them, and takes effect with them: half of
    // the chain linearised elsewhere would hold what nothing observes.
    if (job_ == Job::kLeaves && sweep_.is_on()) return;
    job_ = Job::kJoins;
    if (tree_.is_fresh()) break;
    work_left_ -= tree_.RefreshOne();
    ++report.eliminated_nodes;
  }
  if (job_ == Job::kJoins && tree_.is_fresh()) {
    job_ = Job::kNone;
    stale_ = dirty_;
    sweep_.is_due = prior_is_old_ = true;
  }
}

void ArrowSmoother::Scan() {
  if (!sweep_.is_on()) {
    const bool has_moved = NoteMovedLandmarks();
    if (++sweep_.since_whole < kUpdatesPerWhole && !has_moved && !sweep_.is_due) return;
    BeginSweep();
  }
  for (int leaves = 0; leaves < kLeavesPerScan && sweep_.at > 0; ++leaves) {
    const int leaf = sweep_.at - 1;
    int down_to = -1;
    for (const ArrowStretch* stretch : tree_.PathTo(leaf)) {
      if (stretch->end == sweep_.at && IsCalm(*stretch)) {
        down_to = stretch->first;
        break;
      }
      SolveStretch(*stretch);
    }
    if (down_to < 0) {
      down_to = leaf;
      sweep_.visit.erase(leaf);
      if (IsStrained(tree_.leaf(leaf), anchors_[AsIndex(leaf)], anchors_[AsIndex(leaf + 1)])) {
        dirty_.insert(leaf);
        stale_.insert(leaf);
      }
    }
    SweepTo(down_to);
  }
  if (sweep_.at == 0) sweep_.at = -1;
}

void ArrowSmoother::BeginSweep() {
  sweep_.is_due = false;
  sweep_.is_whole = sweep_.since_whole >= kUpdatesPerWhole;
  if (sweep_.is_whole) sweep_.since_whole = 0;
  sweep_.at = tree_.size();
  sweep_.has_moved = true;  // the last anchor does with every look
}

void ArrowSmoother::SweepTo(int anchor) {
  sweep_.at = anchor;
  sweep_.has_moved = HasMovedSinceSweep(anchor);
  if (sweep_.has_moved) sweep_.anchors[AsIndex(anchor)] = anchors_[AsIndex(anchor)];
}

bool ArrowSmoother::IsCalm(const ArrowStretch& stretch) const {
  const auto visit = sweep_.visit.lower_bound(stretch.first);
  if (sweep_.is_whole || sweep_.has_moved ||
      (visit != sweep_.visit.end() && *visit < stretch.end)) {
    return false;
  }
  // Without a begin, all that it depends on is its end and the blocks.
  if (stretch.has_begin && HasMovedSinceSweep(stretch.first)) return false;
  return std::ranges::none_of(stretch.middle_slots,
                              [this](int slot) { return sweep_.moved[AsIndex(slot)]; });
}

bool ArrowSmoother::NoteMovedLandmarks() {
  const double enough = kMovedShare * params_.relinearize_distance;
  bool has_any = false;
  sweep_.moved.assign(is_landmark_.size(), false);
  for (std::size_t slot = 0; slot < is_landmark_.size(); ++slot) {
    const Eigen::Map<const Eigen::Vector3d> now(&border_[3 * slot]);
    Eigen::Map<Eigen::Vector3d> then(&sweep_.border[3 * slot]);
    if (!is_landmark_[slot] || (now - then).lpNorm<Eigen::Infinity>() <= enough) continue;
    then = now;
    sweep_.moved[slot] = has_any = true;
  }
  return has_any;
}

bool ArrowSmoother::HasMovedSinceSweep(int anchor) const {
  const NavVector moved = (anchors_[AsIndex(anchor)] - sweep_.anchors[AsIndex(anchor)]).cwiseAbs();
  return moved.head<3>().maxCoeff() > kMovedShare * params_.relinearize_distance ||
         moved.tail<3>().maxCoeff() > kMovedShare * params_.relinearize_angle;
}

void ArrowSmoother::LinearizeAll() {
  dirty_.clear();
  stale_.clear();
  job_ = Job::kNone;
  sweep_.at = -1;
  std::vector<ArrowLeaf> leaves;
  for (int leaf = 0; leaf < tree_.size(); ++leaf) {
    const int anchor = leaf * ArrowLeaf::kNodes;
    ArrowLeaf& rebuilt = leaves.emplace_back(anchor, graph_.node(anchor).x);
    for (int i = 0; i < ArrowLeaf::kNodes; ++i)
      rebuilt.Extend(graph_, border_);
    sweep_.anchors[AsIndex(leaf)] = rebuilt.x_anchor();
  }
  sweep_.border = border_;
  for (ClosedBlock& block : tree_.closed())
    block = Closed(block.slot);
  tree_.ReplaceAll(std::move(leaves));
  open_ = ArrowLeaf(open_.anchor(), graph_.node(open_.anchor()).x);
  while (open_.head() < graph_.node_count() - 1)
    open_.Extend(graph_, border_);
  open_is_dirty_ = false;
  prior_is_old_ = true;
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
