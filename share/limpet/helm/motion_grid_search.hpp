// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "limpet/helm/motion_domain.hpp"
#include "limpet/helm/motion_table.hpp"
#include "limpet/helm/peak.hpp"

namespace limpet {

struct WeightedTable {
  const MotionTable* table = nullptr;  ///< over the search's domain
  double weight = 1.0;
};

/// Preferences to be added: tables, and by variable peaks.
struct MotionPreferences {
  std::span<const WeightedTable> tables;
  std::array<std::span<const WeightedPeak>, 3> peaks;
};

/// The exact maximiser, over the points of a domain, of weighted preferences of which some join
/// variables. Every point is looked at; nothing is allocated after construction.
class MotionGridSearch {
 public:
  explicit MotionGridSearch(const MotionDomain& domain);

  /// The best value of each variable that a table covers, nothing for the others: those stand
  /// apart. Of points whose sums differ by less than a billionth of all weights, the one nearest to
  /// `reference` (its course in (-pi, pi]) is taken: nearest in course, then in speed, then in
  /// depth; of two as near, the first of the domain.
  [[nodiscard]] std::array<std::optional<double>, 3> Maximise(
      const MotionPreferences& preferences, const std::array<double, 3>& reference);

 private:
  /// Notes which variables are in this search; false if none is.
  bool Join(std::span<const WeightedTable> tables);
  [[nodiscard]] std::array<std::size_t, 3> BestPoint(const MotionPreferences& preferences,
                                                     const std::array<double, 3>& reference);
  /// Adds up, for the points along the innermost variable, what is wanted at one point of the
  /// others; returns the greatest sum.
  double SumRow(const MotionPreferences& preferences, const std::array<std::size_t, 2>& outer);
  void SumPeaks(const MotionPreferences& preferences);
  [[nodiscard]] std::size_t Nearest(std::size_t variable, double reference,
                                    std::span<const double> sums, double least) const;
  [[nodiscard]] double Distance(std::size_t variable, std::size_t point, double reference) const;

  std::array<bool, 3> is_joined_{};                 ///< by variable: a table covers it
  std::size_t inner_ = 2;                           ///< the last of these
  std::array<std::vector<double>, 3> coordinates_;  ///< points by variable; one 0 if it is absent
  std::array<std::vector<double>, 3> peak_sums_;
  std::vector<double> row_, row_best_, course_best_;
};

}  // namespace limpet
