// SPDX-License-Identifier: MIT
// Elimination of a chain with a border: small kernels over plain arrays, so that they compile and
// run fast. Platform notes 2c, design iv.
#pragma once

#include <array>
#include <vector>

#include "estimation/smoothing/term.hpp"

namespace limpet {

/// What all eliminated poses say about the pose x at the chain's head and the landmarks B of the
/// border: the quadratic 0.5 d'A d - g'd in the changes d = (x, B) from where they are linearised.
struct ArrowMessage {
  int border = 0;         ///< columns of B in use, three per landmark slot
  std::vector<double> A;  ///< (6 + border)^2, column-major, lower triangle
  std::vector<double> g;

  ArrowMessage();
  [[nodiscard]] int size() const { return 6 + border; }
  [[nodiscard]] double& at(int row, int column) {
    return A[static_cast<std::size_t>(column) * static_cast<std::size_t>(size()) +
             static_cast<std::size_t>(row)];
  }
  [[nodiscard]] double at(int row, int column) const {
    return const_cast<ArrowMessage*>(this)->at(row, column);
  }
  void GrowBorder(int border_columns);
  /// Adds a term on the head pose, or on it and the landmark of `slot`.
  void AddPoseTerm(const LinearTerm& term, int slot);
  /// Adds a term on the landmark of `slot` alone.
  void AddLandmarkTerm(const LinearTerm& term, int slot);
};

/// An eliminated pose, given the next pose and the border:  L'x = d - W (next, B).
struct ArrowConditional {
  std::array<double, 36> L{};  ///< lower triangle, column-major
  std::array<double, 6> d{};
  std::vector<double> W;  ///< 6 x (6 + border), column-major
  int held = 0;           ///< directions that nothing observes, one bit each
};

/// Eliminates the head pose of `message`, whose terms are in already; `step` leads to the next
/// pose, which becomes the head.
[[nodiscard]] ArrowConditional EliminateHead(ArrowMessage& message, const LinearTerm& step);

/// The eliminated pose's change, given that of the next pose and of the border.
[[nodiscard]] NavVector BackSubstitute(const ArrowConditional& conditional, const NavVector& next,
                                       const std::vector<double>& border);

/// The root: newest pose and all landmarks, dense.
class ArrowRoot {
 public:
  /// Factorises; directions that nothing observes are held.
  void Solve(ArrowMessage message);
  [[nodiscard]] const NavVector& pose() const { return pose_; }
  [[nodiscard]] const std::vector<double>& border() const { return border_; }
  [[nodiscard]] int border_columns() const { return static_cast<int>(border_.size()); }
  /// Joint covariance of (pose, border), computed on first use; held directions get a huge
  /// variance.
  [[nodiscard]] const Eigen::MatrixXd& covariance() const;
  [[nodiscard]] const std::vector<int>& held() const { return held_; }

 private:
  int n_ = 0;
  std::vector<double> L_;  ///< n x n, column-major
  NavVector pose_ = NavVector::Zero();
  std::vector<double> border_;
  std::vector<int> held_;
  mutable Eigen::MatrixXd covariance_;
  mutable bool has_covariance_ = false;
};

}  // namespace limpet
