// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "estimation/smoothing/joint_prior.hpp"
#include "estimation/smoothing/term.hpp"

namespace limpet {

/// Names a term, so that it can be taken out again.
struct TermId {
  int node;
  int serial;
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

/// A variable of three numbers that any pose may depend on: a landmark's place [m, in W], or slow
/// errors of the sensors. Its number is a slot that is used again after its removal.
struct BorderVariable {
  bool is_used = false;
  bool is_reserved = false;                     ///< not yet to be used again
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< where it is linearised
  std::vector<Term> terms;                      ///< on border variables alone
  std::vector<int> nodes;                       ///< that see it, ascending, one entry per term
};

/// Poses in order of time, each tied to its neighbours, and a border of landmarks and slow errors
/// that any pose may depend on: the factor graph [Dellaert 2006] of [Bucci 2025] eq. (6). Holds
/// variables and terms; solving is somebody else's.
class ChainGraph {
 public:
  /// REQUIRES: a step with a slot names one in use.
  int AddNode(const NavVector& x, std::optional<Term> step);
  /// REQUIRES: a term on border variables names some in use.
  TermId AddTerm(int node, Term term);
  void RemoveTerm(const TermId& id);
  int AddBorderVariable(const Eigen::Vector3d& start);
  /// Also removes every term on it. REQUIRES: no step depends on it.
  void RemoveBorderVariable(int slot);
  /// REQUIRES: `term` is on border variables alone, this the first of them.
  void AddBorderTerm(int slot, Term term);
  /// Replaces all terms that were added with this slot.
  void SetBorderTerms(int slot, std::vector<Term> terms);
  /// Takes the place of the former one; nothing takes it away. A landmark that is removed leaves
  /// it. REQUIRES: it names landmarks in use, each once.
  void SetJointPrior(std::optional<JointPrior> prior);
  [[nodiscard]] const std::optional<JointPrior>& joint_prior() const { return joint_prior_; }

  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] int slot_count() const { return static_cast<int>(border_.size()); }
  [[nodiscard]] const ChainNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] ChainNode& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const BorderVariable& border(int slot) const {
    return border_[static_cast<std::size_t>(slot)];
  }
  [[nodiscard]] BorderVariable& border(int slot) { return border_[static_cast<std::size_t>(slot)]; }

  /// Linearises a term of a node, its step, or a term of the border where the variables now are.
  void Linearize(int node, const Term& term, LinearTerm& out) const;
  void LinearizeStep(int node, LinearTerm& out) const;
  void LinearizeBorder(const Term& term, LinearTerm& out) const;
  /// Sum of all losses where the variables now are.
  [[nodiscard]] double Cost() const;

 private:
  [[nodiscard]] std::array<const Eigen::Vector3d*, kMostBorders> PointsOf(const Term& term) const {
    std::array<const Eigen::Vector3d*, kMostBorders> points{};
    std::ranges::transform(term.slots(), points.begin(),
                           [this](int slot) { return &border(slot).x; });
    return points;
  }
  /// A term of this node on these border variables goes.
  void Forget(int node_index, std::span<const int> slots);

  std::vector<ChainNode> nodes_;
  std::vector<BorderVariable> border_;
  std::optional<JointPrior> joint_prior_;
  int next_serial_ = 0;
};

}  // namespace limpet
