// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "estimation/smoothing/arrow_elimination.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

struct ArrowParams {
  double relinearize_position = 0.02;  ///< a pose is linearised anew when it moves further [m]
  double relinearize_angle = 0.003;    ///< or turns further [rad]
  double relinearize_landmark = 0.03;  ///< the same for a landmark [m]
  double refresh = 1e-6;               ///< change below which back-substitution stops
  int rounds_per_update = 3;           ///< relinearisations in one Update
  int rounds_to_converge = 40;
};

/// Incremental smoother for a chain of poses with a border of landmarks: poses are eliminated in
/// order of time, the root is the newest pose with all landmarks. A new pose costs one elimination
/// and one dense solve of the root; a change to an old pose restarts at the checkpoint before it.
/// It is a Bayes tree for this class of graphs, so after relinearisation it is exact.
class ArrowSmoother final : public Smoother {
 public:
  explicit ArrowSmoother(const ArrowParams& params = {}) : params_(params) {}

  int AddNode(const NavVector& x, std::optional<Term> step) override;
  TermId AddTerm(int node, Term term) override;
  void RemoveTerm(const TermId& id) override;
  int AddLandmark(const Eigen::Vector3d& p) override;
  void RemoveLandmark(int landmark) override;
  void AddLandmarkTerm(int landmark, Term term) override;
  SolveReport Update() override;
  SolveReport Converge() override;

  [[nodiscard]] const ChainGraph& graph() const override { return graph_; }
  [[nodiscard]] NavVector PoseAt(int node) const override;
  [[nodiscard]] Eigen::Vector3d LandmarkAt(int landmark) const override;
  [[nodiscard]] JointCovariance Covariance(const std::vector<int>& landmarks) const override;
  [[nodiscard]] NavCovariance PoseCovariance(int node) const override;

 private:
  void MarkDirty(int node);
  /// Goes back to the checkpoint at or before `node`.
  void Rewind(int node);
  /// Moves the linearisation to the estimate wherever the head's message does not depend on it.
  void RelinearizeFromHead();
  void EliminateToEnd();
  void SolveRoot();
  void BackSubstituteAll();
  /// Earliest node to rewind to so that what moved too far is linearised anew, or node_count().
  [[nodiscard]] int FirstToRelinearize() const;
  [[nodiscard]] Eigen::Vector3d LandmarkChange(int landmark) const;
  void Solve(SolveReport& report);
  /// Moves all variables along the last solution, shortened until the cost does not rise.
  void StepAll(double& cost);
  void MoveBy(double share, const std::vector<NavVector>& change,
              const std::vector<double>& border);

  ArrowParams params_;
  ChainGraph graph_;
  ArrowMessage message_;  ///< at the head, without the head's own terms
  int head_ = 0;          ///< all nodes before it are eliminated
  int dirty_from_ = INT32_MAX;
  int fresh_from_ = 0;  ///< conditionals from here on are newer than the last back-substitution
  std::vector<ArrowConditional> conditionals_;
  std::vector<ArrowMessage> checkpoints_;
  ArrowRoot root_;
  std::vector<NavVector> change_;      ///< estimate less linearisation, per node
  std::vector<double> border_change_;  ///< same per landmark coordinate
  std::vector<double> border_in_use_;  ///< the border that all of change_ was computed with
};

}  // namespace limpet
