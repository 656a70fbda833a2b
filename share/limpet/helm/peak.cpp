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

/// What decides among candidates whose sums are equal; less of the first is better, then less of
/// the second.
struct Discord {
  double beyond_limits = 0.0;  ///< weighted metres
  /// How far from what was wished, where it makes no difference any more: weighted metres beyond
  /// the tops.
  double dissent = 0.0;
};

Discord DiscordAt(std::span<const WeightedPeak> peaks, double x, const Interval& domain) {
  Discord discord;
  for (const auto& [peak, weight] : peaks) {
    discord.beyond_limits += weight * BeyondLimit(peak, x, domain);
    discord.dissent += weight * BeyondTop(peak, x);
  }
  return discord;
}

bool IsLess(const Discord& one, const Discord& other) {
  constexpr double kLevel = 1e-9;
  if (std::abs(one.beyond_limits - other.beyond_limits) > kLevel) {
    return one.beyond_limits < other.beyond_limits;
  }
  return one.dissent < other.dissent - kLevel;
}

/// Keeps the best of the candidates it is shown; of equals that of least discord, then the first.
template <class Distance>
class BestOf {
 public:
  BestOf(std::span<const WeightedPeak> peaks, Distance distance)
      : peaks_(peaks), distance_(distance) {}

  void Consider(double candidate, const Discord& discord = {}) {
    constexpr double kLevel = 1e-9;  // rounding must not let a knee beat an equal summit
    const double value = SumAt(peaks_, candidate, distance_);
    const bool is_as_good = value > best_value_ - kLevel && IsLess(discord, best_discord_);
    if (!has_any_ || value > best_value_ + kLevel || is_as_good) {
      best_ = candidate;
      best_value_ = value;
      best_discord_ = discord;
    }
    has_any_ = true;
  }
  [[nodiscard]] double best() const { return best_; }

 private:
  std::span<const WeightedPeak> peaks_;
  Distance distance_;
  double best_ = 0.0, best_value_ = 0.0;
  Discord best_discord_;
  bool has_any_ = false;
};

}  // namespace

double PeakValue(const Peak& peak, double distance) {
  const double top = peak.flat_half_width;
  const double beyond = std::abs(distance) - top;
  if (beyond <= 0.0) {
    return top > 0.0 ? 1.0 - (1.0 - peak.edge_value) * std::abs(distance) / top : 1.0;
  }
  const double edge = top > 0.0 ? peak.edge_value : 1.0;
  return edge * std::clamp(1.0 - beyond / (peak.base_half_width - top), 0.0, 1.0);
}

double BeyondLimit(const Peak& peak, double x, const Interval& domain) {
  const bool is_limit = peak.edge_value >= 1.0 && peak.summit - peak.flat_half_width <= domain.low;
  return is_limit ? std::max(0.0, x - (peak.summit + peak.flat_half_width)) : 0.0;
}

double BeyondTop(const Peak& peak, double x) {
  return std::max(0.0, std::abs(x - peak.summit) - peak.flat_half_width);
}

double MaximizeOverInterval(std::span<const WeightedPeak> peaks, const Interval& domain) {
  LIMPET_REQUIRE(!peaks.empty() && domain.low <= domain.high,
                 "a decision needs a preference and a domain");
  BestOf best(peaks, [](double x, double summit) { return x - summit; });
  const auto consider = [&](double x) { best.Consider(x, DiscordAt(peaks, x, domain)); };
  VisitCandidates(peaks, [&](double x) { consider(domain.Nearest(x)); });
  consider(domain.low);
  consider(domain.high);
  return best.best();
}

double MaximizeOverCircle(std::span<const WeightedPeak> peaks) {
  LIMPET_REQUIRE(!peaks.empty(), "a decision needs a preference");
  BestOf best(peaks, [](double x, double summit) { return WrapAngle(x - summit); });
  VisitCandidates(peaks, [&best](double x) { best.Consider(x); });
  return WrapAngle(best.best());
}

}  // namespace limpet
