// SPDX-License-Identifier: MIT
// The seam between what is estimated and how it is solved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// How a solve went. A direction that nothing observes is held where it is and named, not fatal.
struct SolveReport {
  bool has_converged = false;
  int iterations = 0;
  int eliminated_nodes = 0;  ///< work done
  double cost = 0.0;         ///< of Converge; 0 after Update, which does not ask
  std::string reason;
};

/// Of several variables together: poses first, six each as in NavVector (x, y, z [m], yaw, pitch,
/// roll [rad]), then border variables, three each (landmarks: x, y, z in W [m]), both in the order
/// asked.
using JointCovariance = Eigen::MatrixXd;

/// Estimates a chain of poses, landmarks and slow errors of the sensors. Landmarks and sensor
/// errors are border variables of the chain, named by their slots.
class Smoother {
 public:
  virtual ~Smoother() = default;

  /// Appends a pose, `step` apart from the newest one.
  virtual int AddNode(const NavVector& x, std::optional<Term> step) = 0;
  virtual TermId AddTerm(int node, Term term) = 0;
  virtual void RemoveTerm(const TermId& id) = 0;
  virtual int AddLandmark(const Eigen::Vector3d& p_W) = 0;
  /// Three slow errors of the sensors, on which steps may depend; never removed.
  virtual int AddSensorErrors(const Eigen::Vector3d& start) = 0;
  /// Three errors of a camera, on which looks at landmarks may depend; never removed.
  virtual int AddCameraErrors(const Eigen::Vector3d& start) = 0;
  /// Logarithms of three objects' sizes, on which looks at them may depend; never removed.
  virtual int AddObjectSizes(const Eigen::Vector3d& start) = 0;
  /// No term on these errors is added from now on, by any node: they need not be kept at hand.
  virtual void CloseSensorErrors(int slot) = 0;
  virtual void RemoveLandmark(int landmark) = 0;
  /// A term on border variables alone, of which `slot` is the first.
  virtual void AddBorderTerm(int slot, Term term) = 0;
  /// Replaces all terms that were added so with this slot, which is not closed; on the same
  /// variables.
  virtual void SetBorderTerms(int slot, std::vector<Term> terms) = 0;
  /// What is known beforehand of several landmarks together; takes the place of the former one.
  virtual void SetJointPrior(std::optional<JointPrior> prior) = 0;
  /// The next poses may see these landmarks and sizes, or be asked about with them. Others that no
  /// pose has seen for a while may take longer to answer about.
  virtual void KeepAtHand(const std::vector<int>& slots) = 0;
  /// True if estimate and covariance of the variable cost no more than those of the newest pose.
  [[nodiscard]] virtual bool IsAtHand(int slot) const = 0;
  /// Takes out the landmark's own terms on two variables; takes effect with the next update.
  virtual void RemovePairTerms(int landmark) = 0;
  /// True if no term on the landmark that was taken out still has an effect.
  [[nodiscard]] virtual bool HasCaughtUp(int landmark) const = 0;

  /// Takes in what is new; cheap, near the optimum.
  virtual SolveReport Update() = 0;
  /// Iterates to the optimum.
  virtual SolveReport Converge() = 0;

  [[nodiscard]] virtual const ChainGraph& graph() const = 0;
  /// Variables that are solved with the newest pose, as of the last Update: those not closed.
  [[nodiscard]] virtual int border_size() const = 0;
  /// Estimates as of the last Update.
  [[nodiscard]] virtual NavVector PoseAt(int node) const = 0;
  [[nodiscard]] virtual Eigen::Vector3d BorderAt(int slot) const = 0;
  /// Joint covariance of the newest pose and border variables; at hand at any time.
  [[nodiscard]] virtual JointCovariance Covariance(const std::vector<int>& slots) const = 0;
  /// Of any poses of the chain, however far back, and any border variables; exact where the factors
  /// are linearised. Takes longer than Covariance, the more so the more poses are asked for. A
  /// variable that no update has seen yet is as good as unknown. REQUIRES: the last Update knew the
  /// nodes.
  [[nodiscard]] virtual JointCovariance CovarianceOf(const std::vector<int>& nodes,
                                                     const std::vector<int>& slots) const = 0;
  /// Covariances of border variables, each alone.
  [[nodiscard]] virtual std::vector<Eigen::Matrix3d> BorderCovariances(
      const std::vector<int>& slots) const = 0;
  /// Covariances of all poses that the last Update knew, each alone: work that grows as their
  /// number does.
  [[nodiscard]] virtual std::vector<NavCovariance> PoseCovariances() const = 0;
  [[nodiscard]] NavCovariance PoseCovariance(int node) const { return CovarianceOf({node}, {}); }
};

}  // namespace limpet
