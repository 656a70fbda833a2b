// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "estimation/smoothing/border_terms.hpp"
#include "estimation/smoothing/damped_step.hpp"
#include "estimation/smoothing/joint_covariance.hpp"

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

bool HasSettled(const ArrowParams& params, double before, double cost) {
  return std::abs(before - cost) <= params.converged_decrease * std::max(cost, 1.0);
}

}  // namespace

ArrowSmoother::ArrowSmoother(const ArrowParams& params)
    : params_(params),
      chain_(params.most_at_hand),
      search_(params.relinearize),
      relinearization_(params.work_per_update) {}

int ArrowSmoother::AddNode(const NavVector& x, std::optional<Term> step) {
  return chain_.AddNode(x, std::move(step));
}

TermId ArrowSmoother::AddTerm(int node, Term term) {
  WakeNow(term.slots());
  NoteChange(node);
  return chain_.AddTerm(node, std::move(term));
}

void ArrowSmoother::RemoveTerm(const TermId& id) {
  NoteChange(id.node);
  chain_.graph().RemoveTerm(id);
}

void ArrowSmoother::NoteChange(int node) {
  if (const auto leaf = chain_.NoteChange(node)) relinearization_.Add(*leaf);
}

void ArrowSmoother::KeepAtHand(const std::vector<int>& slots) {
  chain_.Need(slots);
  needed_ = chain_.Resting(slots);
  BringUpToDate(needed_);
}

void ArrowSmoother::BringUpToDate(const std::vector<int>& resting) const {
  for (const int slot : resting)
    static_cast<void>(estimates_.BorderAt(slot));  // leaves are linearised where it is
}

void ArrowSmoother::Wake(const std::vector<int>& resting) {
  if (resting.empty()) return;
  chain_.Wake(resting);
  is_root_old_ = true;
}

void ArrowSmoother::WakeNow(std::span<const int> slots) {
  const std::vector<int> resting = chain_.Resting(slots);
  if (resting.empty()) return;
  BringUpToDate(resting);
  Wake(resting);
  SolveReport solved;
  SolveRoot(solved, 0);
}

int ArrowSmoother::AddBorderVariable(const Eigen::Vector3d& start, BorderKind kind) {
  const int slot = chain_.AddBorderVariable(start, kind);
  estimates_.AddBorderVariable(slot, start);
  search_.AddBorderVariable(slot, start);
  is_root_old_ = true;
  return slot;
}

int ArrowSmoother::AddLandmark(const Eigen::Vector3d& p_W) {
  return AddBorderVariable(p_W, BorderKind::kLandmark);
}

int ArrowSmoother::AddSensorErrors(const Eigen::Vector3d& start) {
  return AddBorderVariable(start, BorderKind::kSensorErrors);
}

int ArrowSmoother::AddCameraErrors(const Eigen::Vector3d& start) {
  return AddBorderVariable(start, BorderKind::kCameraErrors);
}

int ArrowSmoother::AddObjectSizes(const Eigen::Vector3d& start) {
  return AddBorderVariable(start, BorderKind::kObjectSizes);
}

void ArrowSmoother::CloseSensorErrors(int slot) { chain_.Close(slot); }

void ArrowSmoother::RemoveLandmark(int landmark) {
  WakeNow(std::array{landmark});
  ChainGraph& graph = chain_.graph();
  for (const int node : graph.border(landmark).nodes)
    NoteChange(node);
  graph.RemoveBorderVariable(landmark);
  // Leaves and tree still know it: nothing else may take its place before they do not.
  graph.border(landmark).is_reserved = true;
  is_root_old_ = true;
}

void ArrowSmoother::AddBorderTerm(int slot, Term term) {
  WakeNow(term.slots());
  chain_.graph().AddBorderTerm(slot, std::move(term));
  is_root_old_ = true;
}

void ArrowSmoother::SetBorderTerms(int slot, std::vector<Term> terms) {
  chain_.graph().SetBorderTerms(slot, std::move(terms));
  is_root_old_ = true;
}

void ArrowSmoother::SetJointPrior(std::optional<JointPrior> prior) {
  if (prior) WakeNow(prior->slots());
  chain_.graph().SetJointPrior(std::move(prior));
  is_root_old_ = true;
}

void ArrowSmoother::RemovePairTerms(int landmark) {
  std::erase_if(chain_.graph().border(landmark).terms,
                [](const Term& term) { return term.slots().size() > 1; });
  is_root_old_ = true;
}

bool ArrowSmoother::HasCaughtUp(int landmark) const {
  const std::optional<LeafRange>& leaves = chain_.status(landmark).leaves;
  return (!leaves || relinearization_.IsUpToDate(*leaves)) && !chain_.is_open_leaf_dirty();
}

void ArrowSmoother::BeginIfNew() {
  if (chain_.has_begun()) return;
  chain_.Begin();
  estimates_.AddAnchor(chain_.graph().node(0).x);
}

void ArrowSmoother::ExtendToEnd() {
  chain_.RebuildOpenLeafIfDirty(estimates_.border());
  while (chain_.open_leaf().head() < chain_.graph().node_count() - 1) {
    if (!chain_.ExtendOpenLeaf(estimates_.border())) continue;
    Wake(chain_.Resting(std::exchange(needed_, {})));
    search_.AddLeaf(estimates_.LastAnchor());
    estimates_.AddAnchor(chain_.open_leaf().x_anchor());
    is_root_old_ = true;
  }
}

bool ArrowSmoother::HasOpenLeafMoved() const {
  const auto moved =
      chain_.open_leaf().DisplacementAt({.anchor = root_.anchor(), .head = root_.head()},
                                        estimates_.border(), chain_.border_status());
  return Exceeds(moved, params_.relinearize);
}

void ArrowSmoother::SolveRoot(SolveReport& report, int relinearizations) {
  for (int round = 0;; ++round) {
    ++report.iterations;
    const ArrowMessage message = chain_.OpenMessage(estimates_.border());
    if (std::exchange(is_root_old_, false)) {
      const BorderInformation known = CollectBorderInformation(
          chain_.graph(), chain_.tree(), chain_.border_status(), estimates_.border());
      const ArrowOrigin& origin = chain_.tree().origin;
      root_.SetPrior(known.message, known.slots, origin.anchors.back(), origin.border);
    }
    root_.Solve(chain_.open_leaf(), message);
    estimates_.Take(root_);
    if (round >= relinearizations || !HasOpenLeafMoved()) {
      return;
    }
    const std::vector<NavVector> poses = estimates_.LeafEstimates(chain_.tree().size());
    chain_.RelinearizeOpenLeaf(poses, estimates_.border());
  }
}

SolveReport ArrowSmoother::Update() {
  SolveReport report;
  ChainGraph& graph = chain_.graph();
  if (graph.node_count() == 0) {
    return report;
  }
  BeginIfNew();
  const auto progress = relinearization_.Continue(chain_, estimates_, search_);
  is_root_old_ = is_root_old_ || progress.has_new_tree;
  report.eliminated_nodes = progress.eliminated_nodes;
  ExtendToEnd();
  SolveRoot(report, params_.rounds_per_update);
  for (const int leaf : search_.Continue(chain_, estimates_))
    relinearization_.Add(leaf);
  report.has_converged = relinearization_.is_up_to_date() && !search_.is_under_way();
  report.reason = ReasonOf(root_.held());
  for (int slot = 0; slot < graph.slot_count(); ++slot) {
    BorderVariable& variable = graph.border(slot);
    variable.is_reserved = variable.is_reserved && !HasCaughtUp(slot);
  }
  return report;
}

void ArrowSmoother::RelinearizeAll() {
  chain_.RelinearizeAll(estimates_.border());
  relinearization_.Clear();
  search_.Restart(chain_, estimates_.border());
  is_root_old_ = true;
}

bool ArrowSmoother::StepAll(double& cost) {
  ChainGraph& graph = chain_.graph();
  const ChainValues from = ValuesOf(graph);
  ChainValues to{.poses = std::vector<NavVector>(AsIndex(graph.node_count())), .border = {}};
  for (int i = graph.node_count() - 1; i >= 0; --i)
    to.poses[AsIndex(i)] = PoseAt(i);
  for (int slot = 0; slot < graph.slot_count(); ++slot)
    to.border.emplace_back(&estimates_.border()[AsIndex(3 * slot)]);
  const double before = cost;
  const DampedStep step = StepTowards(from, to, before, graph);
  cost = step.cost;
  std::vector<double> border;
  for (int slot = 0; slot < graph.slot_count(); ++slot) {
    const Eigen::Vector3d& p = graph.border(slot).x;
    border.insert(border.end(), p.data(), p.data() + 3);
  }
  estimates_.SetBorder(border);
  if (step.share < 1.0 || !HasSettled(params_, before, cost)) return false;
  // The whole step changed next to nothing: the linearisation that it came from still holds.
  SetValues(from, graph);
  return true;
}

SolveReport ArrowSmoother::Converge() {
  SolveReport report;
  ChainGraph& graph = chain_.graph();
  if (graph.node_count() == 0) {
    return report;
  }
  BeginIfNew();
  ExtendToEnd();
  for (int slot = 0; slot < graph.slot_count(); ++slot)
    graph.border(slot).is_reserved = false;
  // All starts from the estimate, wherever each part is linearised.
  double cost = std::numeric_limits<double>::infinity();
  bool is_linearised = false;
  while (report.iterations < params_.rounds_to_converge && !report.has_converged) {
    if (report.iterations > 0) RelinearizeAll();
    // No part may move before the step as a whole is found good.
    SolveReport solved;
    SolveRoot(solved, 0);
    const double before = cost;
    is_linearised = StepAll(cost);
    ++report.iterations;
    report.eliminated_nodes += graph.node_count();
    report.has_converged = HasSettled(params_, before, cost);
  }
  if (!is_linearised) {
    RelinearizeAll();
    SolveReport solved;
    SolveRoot(solved, 0);
  }
  report.cost = cost;
  report.reason = report.has_converged ? "cost settled" : "no longer falls within the rounds given";
  return report;
}

JointCovariance ArrowSmoother::Covariance(const std::vector<int>& slots) const {
  if (std::ranges::any_of(slots, [this](int slot) { return chain_.IsClosed(slot); })) {
    return CovarianceOf({chain_.open_leaf().head()}, slots);
  }
  return HeadCovariance(slots, estimates_, root_);
}

JointCovariance ArrowSmoother::CovarianceOf(const std::vector<int>& nodes,
                                            const std::vector<int>& slots) const {
  return limpet::CovarianceOf({.nodes = nodes, .slots = slots}, chain_, estimates_, root_);
}

std::vector<NavCovariance> ArrowSmoother::PoseCovariances() const {
  return limpet::PoseCovariances(chain_, root_);
}

std::vector<Eigen::Matrix3d> ArrowSmoother::BorderCovariances(const std::vector<int>& slots) const {
  if (std::ranges::any_of(slots, [this](int slot) { return chain_.IsClosed(slot); })) {
    return limpet::BorderCovariances(slots, chain_, estimates_, root_);
  }
  std::vector<Eigen::Matrix3d> covariances;
  for (const int slot : slots)
    covariances.emplace_back(Covariance({slot}).bottomRightCorner<3, 3>());
  return covariances;
}

}  // namespace limpet
