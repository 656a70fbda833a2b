// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/smoothing/joint_prior.hpp"
#include "estimation/smoothing/term.hpp"

namespace limpet {

/// Names a term, so that it can be taken out again.
struct TermId {
  int node = -1;
  int serial = -1;
};

/// A pose of the chain, its own terms and the step from the pose before it.
struct ChainNode {
  struct Entry {
    int serial;
    Term term;
  };
  NavVector x = NavVector::Zero();  ///< where the node is linearised
  std::optional<Term> step;
  std::vector<Entry> terms;
};

/// A block of three of the chain's border: a landmark's place, or slow errors of the sensors. Its
/// number is a slot that is used again after its removal.
struct ChainLandmark {
  bool is_used = false;
  bool is_reserved = false;                     ///< not yet to be used again
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< where it is linearised
  std::vector<Term> terms;                      ///< on blocks of the border alone
  std::vector<int> nodes;                       ///< that see it, ascending, one entry per term
};

/// Poses in order of time, each tied to its neighbours, and a border of landmarks and slow errors
/// that any pose may depend on: the factor graph of eq. (6). Holds variables and terms; solving is
/// somebody else's.
class ChainGraph {
 public:
  /// REQUIRES: a step with a slot names one in use.
  int AddNode(const NavVector& x, std::optional<Term> step);
  /// REQUIRES: a term on a landmark names one in use.
  TermId AddTerm(int node, Term term);
  void RemoveTerm(const TermId& id);
  int AddLandmark(const Eigen::Vector3d& p);
  /// Also removes every term on it. REQUIRES: no step depends on it.
  void RemoveLandmark(int landmark);
  /// REQUIRES: `term` is on this landmark, alone or with a second one.
  void AddLandmarkTerm(int landmark, Term term);
  /// Takes the place of the former one; nothing takes it away. A landmark that is removed leaves
  /// it. REQUIRES: it names landmarks in use, each once.
  void SetJointPrior(std::optional<JointPrior> prior);
  [[nodiscard]] const std::optional<JointPrior>& joint_prior() const { return joint_prior_; }

  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] int slot_count() const { return static_cast<int>(landmarks_.size()); }
  [[nodiscard]] const ChainNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] ChainNode& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const ChainLandmark& landmark(int i) const {
    return landmarks_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] ChainLandmark& landmark(int i) { return landmarks_[static_cast<std::size_t>(i)]; }
  /// First node that sees the landmark, or node_count() if none does.
  [[nodiscard]] int FirstNodeOf(int landmark) const;

  /// Linearises a term of a node, its step, or a term of the border where the variables now are.
  void Linearize(int node, const Term& term, LinearTerm& out) const;
  void LinearizeStep(int node, LinearTerm& out) const;
  void LinearizeBorder(const Term& term, LinearTerm& out) const;
  /// Sum of all losses where the variables now are.
  [[nodiscard]] double Cost() const;

 private:
  [[nodiscard]] const Eigen::Vector3d* PlaceOf(int slot) const {
    return slot < 0 ? nullptr : &landmark(slot).p;
  }
  std::vector<ChainNode> nodes_;
  std::vector<ChainLandmark> landmarks_;
  std::optional<JointPrior> joint_prior_;
  int next_serial_ = 0;
};

}  // namespace limpet
