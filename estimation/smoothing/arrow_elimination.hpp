// SPDX-License-Identifier: MIT
// Elimination of a chain with a border: small kernels over plain arrays, so that they compile and
// run fast. docs/adr/0009.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "estimation/smoothing/term.hpp"

namespace limpet {

/// A number of a node or a block as a place in a vector.
[[nodiscard]] constexpr std::size_t AsIndex(int i) { return static_cast<std::size_t>(i); }

/// Six or three columns of a linear term's Jacobian, and where they belong.
struct JacobianBlock {
  int first = 0;
  int width = 0;
  const double* J = nullptr;  ///< six rows, column-major
};

/// A quadratic 0.5 d'A d - g'd in the changes d = (x, B) of the pose at a chain's head and of a
/// border, from where they are linearised.
struct ArrowMessage {
  int border = 0;         ///< columns of B in use
  std::vector<double> A;  ///< (6 + border)^2, column-major, lower triangle
  std::vector<double> g;

  ArrowMessage() : A(36, 0.0), g(6, 0.0) {}
  [[nodiscard]] int size() const { return 6 + border; }
  [[nodiscard]] double& at(int row, int column) {
    return A[static_cast<std::size_t>(column) * static_cast<std::size_t>(size()) +
             static_cast<std::size_t>(row)];
  }
  [[nodiscard]] double at(int row, int column) const {
    return const_cast<ArrowMessage*>(this)->at(row, column);
  }
  void GrowBorder(int border_columns);
  /// Adds a term; `blocks` in any order.
  void Add(const LinearTerm& term, std::span<const JacobianBlock> blocks);
};

/// What ties the head to the next pose, and the next pose to the border, less what it says about
/// head and border alone: that goes into the message first.
struct ArrowLink {
  std::array<double, 36> head_next{}, next_next{};  ///< column-major; next_next: lower triangle
  std::array<double, 6> g_next{};
  std::vector<int> columns;         ///< of the border, where a block of three begins
  std::vector<double> next_border;  ///< 6 x 3 per entry of `columns`, column-major
};

/// An eliminated pose, given the next pose and the border:  L'x = d - W (next, B).
struct ArrowConditional {
  std::array<double, 36> L{};  ///< lower triangle, column-major
  std::array<double, 6> d{};
  std::vector<double> W;  ///< 6 x (6 + border), row by row
  int held = 0;           ///< directions that nothing observes, one bit each

  [[nodiscard]] int columns() const { return static_cast<int>(W.size() / 6); }
};

/// Eliminates the head pose of `message`; the next pose becomes the head.
[[nodiscard]] ArrowConditional EliminateHead(ArrowMessage& message, const ArrowLink& link);

/// The eliminated pose's change, given that of the next pose and of the border.
[[nodiscard]] NavVector BackSubstitute(const ArrowConditional& conditional, const NavVector& next,
                                       const double* border);

}  // namespace limpet
