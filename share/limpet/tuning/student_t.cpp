// SPDX-License-Identifier: MIT
#include "limpet/tuning/student_t.hpp"

#include <cmath>
#include <numeric>

#include <unsupported/Eigen/SpecialFunctions>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kConfidence = 0.95;

}  // namespace

double StudentProbability(double t, double degrees) {
  LIMPET_REQUIRE(degrees > 0.0, "no degrees of freedom");
  const double tail = 0.5 * Eigen::numext::betainc(0.5 * degrees, 0.5, degrees / (degrees + t * t));
  return t > 0.0 ? 1.0 - tail : tail;
}

double StudentQuantile(double p, double degrees) {
  LIMPET_REQUIRE(p > 0.0 && p < 1.0, "no probability");
  double low = -1.0, high = 1.0;
  while (StudentProbability(low, degrees) > p)
    low *= 2.0;
  while (StudentProbability(high, degrees) < p)
    high *= 2.0;
  constexpr int kHalvings = 200;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (StudentProbability(middle, degrees) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

MeanInterval IntervalOf(const std::vector<double>& values) {
  LIMPET_REQUIRE(!values.empty(), "an interval of nothing");
  const auto count = static_cast<double>(values.size());
  MeanInterval interval;
  interval.count = values.size();
  interval.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  if (values.size() < 2) return interval;
  double squares = 0.0;
  for (const double value : values)
    squares += (value - interval.mean) * (value - interval.mean);
  interval.standard_error = std::sqrt(squares / (count - 1.0) / count);
  const double half =
      StudentQuantile(0.5 + 0.5 * kConfidence, count - 1.0) * interval.standard_error;
  interval.low = interval.mean - half;
  interval.high = interval.mean + half;
  return interval;
}

std::optional<double> ChanceOfSoGreatAMean(const std::vector<double>& differences) {
  if (differences.size() < 2) return std::nullopt;
  const MeanInterval interval = IntervalOf(differences);
  if (interval.standard_error == 0.0) {
    return interval.mean == 0.0 ? 0.5 : (interval.mean > 0.0 ? 0.0 : 1.0);
  }
  return 1.0 - StudentProbability(interval.mean / interval.standard_error,
                                  static_cast<double>(differences.size()) - 1.0);
}

}  // namespace limpet
