// SPDX-License-Identifier: MIT
#include "limpet/tuning/student_t.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kConfidence = 0.95;

/// The continued fraction of the incomplete beta function, by Lentz's method (Abramowitz and
/// Stegun 26.5.8).
double BetaFraction(double a, double b, double x) {
  constexpr int kMostTerms = 500;
  constexpr double kTiny = 1e-300;
  const auto guarded = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
  double c = 1.0, d = 1.0 / guarded(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < kMostTerms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
    d = 1.0 / guarded(1.0 + even * d);
    c = guarded(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
    d = 1.0 / guarded(1.0 + odd * d);
    c = guarded(1.0 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < std::numeric_limits<double>::epsilon()) break;
  }
  return fraction;
}

/// Regularised incomplete beta function I_x(a, b).
double BetaShare(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front = std::exp(a * std::log(x) + b * std::log1p(-x)) / std::beta(a, b);
  // The fraction converges fast on one side of the mean only; the other is its mirror.
  return x < (a + 1.0) / (a + b + 2.0) ? front * BetaFraction(a, b, x) / a
                                       : 1.0 - front * BetaFraction(b, a, 1.0 - x) / b;
}

}  // namespace

double StudentProbability(double t, double degrees) {
  LIMPET_REQUIRE(degrees > 0.0, "no degrees of freedom");
  const double tail = 0.5 * BetaShare(0.5 * degrees, 0.5, degrees / (degrees + t * t));
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
