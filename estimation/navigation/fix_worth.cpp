// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_worth.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/logistic.hpp"

namespace limpet {

double FixRow::Gain(std::optional<double> gap) const {
  return gap ? Logistic(*gap / correlation) - 0.5 : 0.5;
}

double FixRow::WorthOf(std::size_t i) const {
  const std::size_t n = times.size(), end = std::min(n, kEnd);
  // The stay before keeps its own end, so that this one bears all that the two have in common.
  const double in_common = 0.5 - Gain(gap_before);
  const double first = std::max(0.5 - 2.0 * in_common, 0.0);
  const double last = std::min(1.0 - 2.0 * in_common, 0.5);
  double worth = 0.0;
  if (i > 0) worth += Gain(times[i] - times[i - 1]);
  if (i + 1 < n) worth += Gain(times[i + 1] - times[i]);
  if (i < end) worth += first / static_cast<double>(end);
  if (i + end >= n) worth += last / static_cast<double>(end);
  return std::max(worth, 1e-6);
}

std::size_t FixRow::FirstChangedByTheLast() const {
  const std::size_t n = times.size();
  return n > kEnd ? n - kEnd - 1 : 0;
}

}  // namespace limpet
