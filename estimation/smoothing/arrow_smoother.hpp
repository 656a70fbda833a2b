// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "estimation/smoothing/arrow_root.hpp"
#include "estimation/smoothing/arrow_trunk.hpp"
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
/// the trunk eliminates the poses between leaves, the root is the newest leaf on the last anchor
/// and the border. A new pose, and a landmark that is seen again, cost a small dense solve. What
/// has moved far since it was linearised, or lost a term, is done anew behind the scenes, so much
/// per update, and takes effect when it has caught up. It is a Bayes tree for this class of graphs,
/// so after relinearisation it is exact.
class ArrowSmoother final : public Smoother {
 public:
  explicit ArrowSmoother(const ArrowParams& params = {}) : params_(params) {}

  int AddNode(const NavVector& x, std::optional<Term> step) override;
  TermId AddTerm(int node, Term term) override;
  void RemoveTerm(const TermId& id) override;
  int AddLandmark(const Eigen::Vector3d& p) override;
  int AddErrors(const Eigen::Vector3d& start) override;
  void RemoveLandmark(int landmark) override;
  void AddLandmarkTerm(int landmark, Term term) override;
  void SetJointPrior(std::optional<JointPrior> prior) override;
  void Untie(int landmark) override;
  [[nodiscard]] bool HasCaughtUp(int landmark) const override;
  SolveReport Update() override;
  SolveReport Converge() override;

  [[nodiscard]] const ChainGraph& graph() const override { return graph_; }
  [[nodiscard]] NavVector PoseAt(int node) const override;
  [[nodiscard]] Eigen::Vector3d LandmarkAt(int landmark) const override;
  [[nodiscard]] JointCovariance Covariance(const std::vector<int>& landmarks) const override;
  [[nodiscard]] JointCovariance CovarianceOf(const std::vector<int>& nodes,
                                             const std::vector<int>& landmarks) const override;

 private:
  int AddBlock(const Eigen::Vector3d& p, bool is_landmark);
  void MarkDirty(int node);
  void Begin();
  /// Takes the new nodes into the newest leaf; a full one goes to the trunk.
  void ExtendToEnd();
  void CloseLeaf();
  void RebuildOpenLeaf();
  void RebuildLeaf(int leaf);
  /// Solves for the newest poses and the border, and linearises the newest leaf anew where it moved
  /// far, at most so often.
  void SolveRoot(SolveReport& report, int relinearizations);
  void SetPrior();
  void AddJointPrior(ArrowMessage& message) const;
  /// Brings the trunk up to date where that is little work, or goes on doing it behind the scenes.
  void KeepUp(SolveReport& report);
  void KeepUpNow(int from, SolveReport& report);
  void KeepUpBehind(SolveReport& report);
  void AppendTo(ArrowTrunk& trunk, SolveReport& report);
  /// Looks for leaves that have moved too far since they were linearised: from the newest one back
  /// to where nothing has moved since the last sweep.
  void Scan();
  void BeginSweep();
  /// Landmarks that have moved since the last sweep: the sweep must go down to where each was first
  /// seen.
  void NoteMovedLandmarks();
  [[nodiscard]] bool HasMovedSinceSweep(int leaf, const NavVector& anchor) const;
  [[nodiscard]] bool IsStrained(const ArrowLeaf& leaf, const NavVector& x_anchor,
                                const NavVector& x_head) const;
  [[nodiscard]] NavVector AnchorFrom(int anchor, const NavVector& next) const;
  void EnsureAnchors(int anchor) const;
  [[nodiscard]] const std::vector<NavVector>& LeafEstimates(int leaf) const;
  void LinearizeAll();
  /// Goes towards these estimates as far as the cost does not rise. True if that was all the way
  /// and changed next to nothing: then all stays linearised where it was.
  bool StepAll(double& cost, const std::vector<NavVector>& poses,
               const std::vector<double>& border);
  [[nodiscard]] bool HasSettled(double before, double cost) const {
    return std::abs(before - cost) <= params_.converged_decrease * std::max(cost, 1.0);
  }
  [[nodiscard]] double WorkPerAnchor() const { return ArrowTrunk::WorkOf(3 * graph_.slot_count()); }
  [[nodiscard]] bool IsUpToDate() const { return stale_.empty() && !behind_ && !sweep_.is_on(); }

  ArrowParams params_;
  ChainGraph graph_;
  ArrowOrigin origin_;
  std::vector<bool> is_landmark_, is_solved_;  ///< per block of the border
  struct LeafRange {
    int first = 0, last = -1;
  };
  struct Sweep {
    int at = -1;                      ///< anchor that it has come down to; -1: at rest
    NavVector x = NavVector::Zero();  ///< estimate of that anchor
    int floor = kNowhere;             ///< leaf that it goes down to at least
    int due_from = kNowhere;          ///< the same, of the next one; kNowhere: none is due
    int since_whole = 0;              ///< sweeps since one went down to the first leaf
    std::vector<NavVector> anchors;   ///< estimates as they were found last
    std::vector<double> border;
    static constexpr int kNowhere = std::numeric_limits<int>::max();
    [[nodiscard]] bool is_on() const { return at >= 0; }
  };
  std::vector<LeafRange> seen_from_;  ///< per block: leaves that have or had a term on it
  std::vector<ArrowLeaf> leaves_;     ///< full ones
  ArrowLeaf open_;
  bool has_begun_ = false, open_is_dirty_ = false, prior_is_old_ = true;
  ArrowTrunk trunk_;
  ArrowRoot root_;
  std::vector<double> border_;         ///< estimates, three per block
  std::vector<double> border_change_;  ///< the same from the origin

  std::set<int> dirty_;               ///< leaves to be linearised anew
  std::set<int> stale_;               ///< leaves that the trunk has in an old version
  std::vector<int> versions_;         ///< of the leaves
  std::optional<ArrowTrunk> behind_;  ///< the trunk's continuation that is to replace it
  double work_left_ = 0.0;            ///< of this update's share; below zero, owed
  std::vector<int> behind_versions_;  ///< of the leaves it took
  Sweep sweep_;

  mutable std::vector<NavVector> anchors_;  ///< estimates, from solved_from_ on
  mutable int solved_from_ = 0;
  mutable int estimated_leaf_ = -1;  ///< whose poses leaf_estimates_ holds
  mutable std::vector<NavVector> leaf_estimates_;
};

}  // namespace limpet
