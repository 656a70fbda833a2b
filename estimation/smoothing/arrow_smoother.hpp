// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimation/smoothing/arrow_estimates.hpp"
#include "estimation/smoothing/arrow_root.hpp"
#include "estimation/smoothing/moved_leaf_search.hpp"
#include "estimation/smoothing/relinearization.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

struct ArrowParams {
  RelinearizeThresholds relinearize{};
  double work_per_update = 2e5;  ///< multiply-adds of relinearisation in one Update
  int rounds_per_update = 2;     ///< relinearisations of the newest leaf in one Update
  int rounds_to_converge = 40;
  double converged_decrease = 1e-8;  ///< share of the cost
  /// Landmarks and sizes (border variables) up to which all stay in the root, needed or not.
  int most_at_hand = 72;
};

/// Incremental smoother for a chain of poses with a border of landmarks and slow sensor errors: a
/// Bayes tree [Kaess 2012] of a fixed shape for this class of graphs (docs/adr/0009), exact after
/// relinearisation. `ArrowChain` cuts the chain into leaves of sixteen poses and joins the full
/// ones two by two in a tree; `ArrowRoot` solves the newest leaf on the last anchor and the border,
/// so a new pose, and a landmark that is seen again, cost a small dense solve. `MovedLeafSearch`
/// finds what has moved far since it was linearised, `Relinearization` does it anew, so much per
/// update.
class ArrowSmoother final : public Smoother {
 public:
  explicit ArrowSmoother(const ArrowParams& params = {});
  ~ArrowSmoother() override = default;
  ArrowSmoother(const ArrowSmoother&) = delete;
  ArrowSmoother& operator=(const ArrowSmoother&) = delete;

  int AddNode(const NavVector& x, std::optional<Term> step) override;
  TermId AddTerm(int node, Term term) override;
  void RemoveTerm(const TermId& id) override;
  int AddLandmark(const Eigen::Vector3d& p_W) override;
  int AddSensorErrors(const Eigen::Vector3d& start) override;
  int AddCameraErrors(const Eigen::Vector3d& start) override;
  int AddObjectSizes(const Eigen::Vector3d& start) override;
  void CloseSensorErrors(int slot) override;
  void RemoveLandmark(int landmark) override;
  void AddBorderTerm(int slot, Term term) override;
  void SetBorderTerms(int slot, std::vector<Term> terms) override;
  void SetJointPrior(std::optional<JointPrior> prior) override;
  void KeepAtHand(const std::vector<int>& slots) override;
  [[nodiscard]] bool IsAtHand(int slot) const override { return !chain_.IsClosed(slot); }
  void RemovePairTerms(int landmark) override;
  [[nodiscard]] bool HasCaughtUp(int landmark) const override;
  SolveReport Update() override;
  SolveReport Converge() override;

  [[nodiscard]] const ChainGraph& graph() const override { return chain_.graph(); }
  [[nodiscard]] int border_size() const override { return static_cast<int>(root_.slots().size()); }
  [[nodiscard]] NavVector PoseAt(int node) const override { return estimates_.PoseAt(node); }
  [[nodiscard]] Eigen::Vector3d BorderAt(int slot) const override {
    return estimates_.BorderAt(slot);
  }
  [[nodiscard]] JointCovariance Covariance(const std::vector<int>& slots) const override;
  [[nodiscard]] JointCovariance CovarianceOf(const std::vector<int>& nodes,
                                             const std::vector<int>& slots) const override;
  [[nodiscard]] std::vector<Eigen::Matrix3d> BorderCovariances(
      const std::vector<int>& slots) const override;
  [[nodiscard]] std::vector<NavCovariance> PoseCovariances() const override;

 private:
  int AddBorderVariable(const Eigen::Vector3d& start, BorderKind kind);
  void NoteChange(int node);
  /// What rests of these is solved with the newest pose again, from now on.
  void WakeNow(std::span<const int> slots);
  /// Solves for what rests of these: the estimate that leaves are linearised at.
  void BringUpToDate(const std::vector<int>& resting) const;
  /// Takes effect with the next solve.
  void Wake(const std::vector<int>& resting);
  void BeginIfNew();
  /// Takes the new nodes into the newest leaf; a full one goes to the tree.
  void ExtendToEnd();
  /// Solves for the newest poses and the border, and linearises the newest leaf anew where it moved
  /// far, at most so often.
  void SolveRoot(SolveReport& report, int relinearizations);
  [[nodiscard]] bool HasOpenLeafMoved() const;
  void RelinearizeAll();
  /// Goes from the graph's values towards the estimates as far as the cost does not rise. True if
  /// that was all the way and changed next to nothing: then all stays linearised where it was.
  bool StepAll(double& cost);

  ArrowParams params_;
  ArrowChain chain_;
  ArrowRoot root_;
  ArrowEstimates estimates_{chain_};
  MovedLeafSearch search_;
  Relinearization relinearization_;
  std::vector<int> needed_;  ///< that rest and are to be woken with the next leaf
  bool is_root_old_ = true;  ///< tree or border have changed since the root took them up
};

}  // namespace limpet
