// SPDX-License-Identifier: MIT
#include "limpet/helm/peak.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "limpet/core/frames.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// True if `a` comes before `b`: heavier, or as heavy and given earlier.
bool ComesBefore(std::span<const WeightedPeak> peaks, std::size_t a, std::size_t b) {
  return peaks[a].weight > peaks[b].weight || (peaks[a].weight == peaks[b].weight && a < b);
}

/// The heaviest peaks first. Sorting would allocate, and there are few.
template <class Visit>
void VisitByWeight(std::span<const WeightedPeak> peaks, const Visit& visit) {
  std::optional<std::size_t> last;
  for (std::size_t count = 0; count < peaks.size(); ++count) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      const bool is_left = !last || ComesBefore(peaks, *last, i);
      if (is_left && (!next || ComesBefore(peaks, i, *next))) next = i;
    }
    visit(peaks[*next].peak);
    last = next;
  }
}

/// Summits of the heaviest peaks first, then the knees: the first best candidate wins ties.
template <class Visit>
void VisitCandidates(std::span<const WeightedPeak> peaks, const Visit& visit) {
  VisitByWeight(peaks, [&visit](const Peak& peak) { visit(peak.summit); });
  VisitByWeight(peaks, [&visit](const Peak& peak) {
    for (const double offset : {peak.flat_half_width, peak.base_half_width}) {
      visit(peak.summit - offset);
      visit(peak.summit + offset);
    }
  });
}

template <class Distance>
double SumAt(std::span<const WeightedPeak> peaks, double x, Distance distance) {
  return std::transform_reduce(
      peaks.begin(), peaks.end(), 0.0, std::plus<>(), [&](const WeightedPeak& weighted) {
        return weighted.weight * PeakValue(weighted.peak, distance(x, weighted.peak.summit));
      });
}

/// Keeps the best of the candidates it is shown.
template <class Distance>
class BestOf {
 public:
  BestOf(std::span<const WeightedPeak> peaks, Distance distance)
      : peaks_(peaks), distance_(distance) {}

  void Consider(double candidate) {
    constexpr double kLevel = 1e-9;  // rounding must not let a knee beat an equal summit
    const double value = SumAt(peaks_, candidate, distance_);
    if (!has_any_ || value > best_value_ + kLevel) {
      best_ = candidate;
      best_value_ = value;
    }
    has_any_ = true;
  }
  [[nodiscard]] double best() const { return best_; }

 private:
  std::span<const WeightedPeak> peaks_;
  Distance distance_;
  double best_ = 0.0, best_value_ = 0.0;
  bool has_any_ = false;
};

}  // namespace

double PeakValue(const Peak& peak, double distance) {
  const double beyond = std::abs(distance) - peak.flat_half_width;
  const double slope_width = peak.base_half_width - peak.flat_half_width;
  return std::clamp(1.0 - beyond / slope_width, 0.0, 1.0);
}

double MaximizeOverInterval(std::span<const WeightedPeak> peaks, double low, double high) {
  LIMPET_REQUIRE(!peaks.empty() && low <= high, "a decision needs a preference and a domain");
  BestOf best(peaks, [](double x, double summit) { return x - summit; });
  VisitCandidates(peaks, [&](double x) { best.Consider(std::clamp(x, low, high)); });
  best.Consider(low);
  best.Consider(high);
  return best.best();
}

double MaximizeOverCircle(std::span<const WeightedPeak> peaks) {
  LIMPET_REQUIRE(!peaks.empty(), "a decision needs a preference");
  BestOf best(peaks, [](double x, double summit) { return WrapAngle(x - summit); });
  VisitCandidates(peaks, [&best](double x) { best.Consider(x); });
  return WrapAngle(best.best());
}

}  // namespace limpet
