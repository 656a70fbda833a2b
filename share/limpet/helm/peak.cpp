// SPDX-License-Identifier: MIT
#include "limpet/helm/peak.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "limpet/core/frames.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Summits of the heaviest peaks first, then the knees: the first best candidate wins ties.
std::vector<double> Candidates(std::span<const WeightedPeak> peaks) {
  std::vector<WeightedPeak> by_weight(peaks.begin(), peaks.end());
  std::ranges::stable_sort(by_weight, std::ranges::greater{}, &WeightedPeak::weight);
  std::vector<double> candidates;
  for (const WeightedPeak& peak : by_weight) {
    candidates.push_back(peak.peak.summit);
  }
  for (const auto& [peak, weight] : by_weight) {
    for (const double offset : {peak.flat_half_width, peak.base_half_width}) {
      candidates.push_back(peak.summit - offset);
      candidates.push_back(peak.summit + offset);
    }
  }
  return candidates;
}

template <class Distance>
double SumAt(std::span<const WeightedPeak> peaks, double x, Distance distance) {
  return std::transform_reduce(
      peaks.begin(), peaks.end(), 0.0, std::plus<>(), [&](const WeightedPeak& weighted) {
        return weighted.weight * PeakValue(weighted.peak, distance(x, weighted.peak.summit));
      });
}

template <class Distance>
double BestOf(std::span<const WeightedPeak> peaks, const std::vector<double>& candidates,
              Distance distance) {
  constexpr double kTie = 1e-9;  // rounding must not let a knee beat an equal summit
  double best = candidates.front();
  double best_value = SumAt(peaks, best, distance);
  for (const double candidate : candidates) {
    const double value = SumAt(peaks, candidate, distance);
    if (value > best_value + kTie) {
      best = candidate;
      best_value = value;
    }
  }
  return best;
}

}  // namespace

double PeakValue(const Peak& peak, double distance) {
  const double beyond = std::abs(distance) - peak.flat_half_width;
  const double slope_width = peak.base_half_width - peak.flat_half_width;
  return std::clamp(1.0 - beyond / slope_width, 0.0, 1.0);
}

double MaximizeOverInterval(std::span<const WeightedPeak> peaks, double low, double high) {
  LIMPET_REQUIRE(!peaks.empty() && low <= high, "a decision needs a preference and a domain");
  std::vector<double> candidates = Candidates(peaks);
  candidates.push_back(low);
  candidates.push_back(high);
  for (double& candidate : candidates) {
    candidate = std::clamp(candidate, low, high);
  }
  return BestOf(peaks, candidates, [](double x, double summit) { return x - summit; });
}

double MaximizeOverCircle(std::span<const WeightedPeak> peaks) {
  LIMPET_REQUIRE(!peaks.empty(), "a decision needs a preference");
  return WrapAngle(BestOf(peaks, Candidates(peaks),
                          [](double x, double summit) { return WrapAngle(x - summit); }));
}

}  // namespace limpet
