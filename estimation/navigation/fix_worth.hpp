// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace limpet {

/// What the fixes of one stay at the surface are worth, each as a share of a lone fix's information
/// about a place. Their error is a Gauss-Markov process and noise. Weighted so, as if they were
/// independent, they have the process' best linear estimate and, together, its information:
/// 1 + T / (2 correlation) of a row of length T, half a fix of that at either end. The ends are
/// spread over a few fixes, so that no noise of a single one tells where the vehicle is.
struct FixRow {
  /// So many fixes make an end, as far as there are.
  static constexpr std::size_t kEnd = 8;

  double correlation = 120.0;  ///< of the error [s]
  /// Time since the last fix of the stay before [s]; none: there was no other.
  std::optional<double> gap_before{};
  std::vector<double> times{};  ///< of the fixes, in order [s]

  /// REQUIRES: i < times.size(). At least a millionth: of fixes of one time only the ends count.
  [[nodiscard]] double WorthOf(std::size_t i) const;
  /// No fix before this one is worth something else since the last one was appended.
  [[nodiscard]] std::size_t FirstChangedByTheLast() const;

 private:
  /// Beyond half a fix, what a row gains by a gap, or by none [s].
  [[nodiscard]] double Gain(std::optional<double> gap) const;
};

}  // namespace limpet
