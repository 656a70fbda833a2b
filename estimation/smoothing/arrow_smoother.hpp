// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "estimation/smoothing/arrow_root.hpp"
#include "estimation/smoothing/arrow_tree.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

struct ArrowParams {
  double relinearize_angle = 0.01;     ///< a leaf is linearised anew when it turns further [rad]
  double relinearize_distance = 0.05;  ///< or a landmark moves further against its poses [m]
  double work_per_update = 2e5;        ///< multiply-adds of upkeep in one Update
  int rounds_per_update = 2;           ///< relinearisations of the newest leaf in one Update
  int rounds_to_converge = 40;
  double converged_decrease = 1e-8;  ///< share of the cost
};

/// Incremental smoother for a chain of poses with a border of landmarks. The chain is cut into
/// leaves of sixteen poses; each leaf eliminates its inside, knowing only the landmarks it sees;
/// a tree joins the leaves two by two, the root is the newest leaf on the last anchor and the
/// border. A new pose, and a landmark that is seen again, cost a small dense solve. What has moved
/// far since it was linearised, or lost a term, is done anew behind the scenes, so much per update,
/// and takes effect when it has caught up. It is a Bayes tree for this class of graphs, so after
/// relinearisation it is exact.
class ArrowSmoother final : public Smoother {
 public:
  explicit ArrowSmoother(const ArrowParams& params = {}) : params_(params) {}

  int AddNode(const NavVector& x, std::optional<Term> step) override;
  TermId AddTerm(int node, Term term) override;
  void RemoveTerm(const TermId& id) override;
  int AddLandmark(const Eigen::Vector3d& p) override;
  int AddErrors(const Eigen::Vector3d& start) override;
  void CloseErrors(int block) override;
  void RemoveLandmark(int landmark) override;
  void AddLandmarkTerm(int landmark, Term term) override;
  void SetJointPrior(std::optional<JointPrior> prior) override;
  void Untie(int landmark) override;
  [[nodiscard]] bool HasCaughtUp(int landmark) const override;
  SolveReport Update() override;
  SolveReport Converge() override;

  [[nodiscard]] const ChainGraph& graph() const override { return graph_; }
  [[nodiscard]] int border_blocks() const override {
    return static_cast<int>(root_.slots().size());
  }
  [[nodiscard]] NavVector PoseAt(int node) const override;
  [[nodiscard]] Eigen::Vector3d LandmarkAt(int landmark) const override;
  [[nodiscard]] JointCovariance Covariance(const std::vector<int>& landmarks) const override;
  [[nodiscard]] JointCovariance CovarianceOf(const std::vector<int>& nodes,
                                             const std::vector<int>& landmarks) const override;

 private:
  struct LeafRange {
    int first = 0, last = -1;
  };
  /// A search for strained leaves under way, newest first, and what the last one found.
  struct Sweep {
    int at = -1;             ///< anchor that it has come down to; -1: at rest
    bool has_moved = false;  ///< that anchor, since the last sweep
    bool is_whole = false;   ///< visits all leaves
    bool is_due = false;
    int since_whole = 0;         ///< updates
    std::set<int> visit;         ///< leaves to be visited whatever has moved
    std::vector<bool> moved;     ///< per block: since the last sweep
    std::vector<double> border;  ///< estimates as of the last sweep
    std::vector<NavVector> anchors;
    [[nodiscard]] bool is_on() const { return at >= 0; }
  };

  int AddBlock(const Eigen::Vector3d& p, bool is_landmark);
  void MarkDirty(int node);
  void Begin();
  /// Takes the new nodes into the newest leaf; a full one goes to the tree.
  void ExtendToEnd();
  void CloseLeaf();
  /// Blocks of slow errors that nothing depends on from here on leave the border.
  void CloseBlocks();
  [[nodiscard]] ClosedBlock Closed(int slot) const;
  [[nodiscard]] bool IsClosed(int slot) const { return is_closed_[AsIndex(slot)]; }
  void RebuildOpenLeaf();
  void RebuildLeaf(int leaf);
  /// Solves for the newest poses and the border, and linearises the newest leaf anew where it moved
  /// far, at most so often.
  void SolveRoot(SolveReport& report, int relinearizations);
  void SetPrior();
  /// Residual where the changes from the origin are zero.
  void LinearizeBorderTerm(int slot, const Term& term, LinearTerm& linear) const;
  void AddJointPrior(ArrowMessage& message, const std::vector<int>& places) const;
  /// Brings the tree up to date: the newest leaves at once, the others behind the scenes.
  void KeepUp(SolveReport& report);
  void KeepUpNow(int from, SolveReport& report);
  void KeepUpBehind(SolveReport& report);
  /// Looks for leaves that have moved too far since they were linearised, where anything has moved.
  void Scan();
  void BeginSweep();
  /// True if the sweep may pass over all of it: neither ends nor blocks have moved.
  [[nodiscard]] bool IsCalm(const ArrowStretch& stretch) const;
  void SweepTo(int anchor);
  [[nodiscard]] bool HasMovedSinceSweep(int anchor) const;
  [[nodiscard]] bool NoteMovedLandmarks();
  [[nodiscard]] bool IsStrained(const ArrowLeaf& leaf, const NavVector& x_anchor,
                                const NavVector& x_head) const;
  /// Estimates of what the stretch has eliminated.
  void SolveStretch(const ArrowStretch& stretch) const;
  /// Estimates of the leaf's ends and of all blocks that it touches.
  void SolveEndsOf(int leaf) const;
  [[nodiscard]] const std::vector<NavVector>& LeafEstimates(int leaf) const;
  void LinearizeAll();
  /// Goes towards these estimates as far as the cost does not rise. True if that was all the way
  /// and changed next to nothing: then all stays linearised where it was.
  bool StepAll(double& cost, const std::vector<NavVector>& poses,
               const std::vector<double>& border);
  [[nodiscard]] bool HasSettled(double before, double cost) const {
    return std::abs(before - cost) <= params_.converged_decrease * std::max(cost, 1.0);
  }
  [[nodiscard]] bool IsUpToDate() const { return stale_.empty() && !sweep_.is_on(); }

  ArrowParams params_;
  ChainGraph graph_;
  std::vector<bool> is_landmark_, is_solved_, is_closed_;  ///< per block of the border
  std::vector<LeafRange> seen_from_;  ///< per block: leaves that have or had a term on it
  std::map<int, int> to_be_closed_;   ///< blocks, and the last node that may depend on them
  ArrowTree tree_;                    ///< of the full leaves
  ArrowLeaf open_;
  bool has_begun_ = false, open_is_dirty_ = false, prior_is_old_ = true;
  ArrowRoot root_;

  /// Behind the scenes: leaves that have moved are linearised anew, then joined anew.
  enum class Job { kNone, kLeaves, kJoins };

  std::set<int> dirty_;  ///< leaves to be linearised anew
  std::set<int> stale_;  ///< leaves that the root knows in an old version
  Job job_ = Job::kNone;
  double work_left_ = 0.0;  ///< of this update's share; below zero, owed
  Sweep sweep_;

  // Estimates; those of old anchors and closed blocks are filled in when they are asked for.
  mutable std::vector<double> border_;         ///< three per block
  mutable std::vector<double> border_change_;  ///< the same from the origin
  mutable std::vector<NavVector> anchors_;
  mutable std::vector<int> solved_at_;  ///< per anchor: the solve that its estimate is of
  int solve_ = 0;
  mutable int estimated_leaf_ = -1;  ///< whose poses leaf_estimates_ holds
  mutable std::vector<NavVector> leaf_estimates_;
};

}  // namespace limpet
