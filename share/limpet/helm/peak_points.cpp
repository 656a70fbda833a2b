// SPDX-License-Identifier: MIT
#include "limpet/helm/peak_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "limpet/core/frames.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kLevel = 1e-9;  ///< of values: rounding must not decide

double Away(double x, double summit, MotionVariable variable) {
  return std::abs(variable == MotionVariable::kCourse ? WrapAngle(x - summit) : x - summit);
}

/// A point with what speaks for it and against it.
struct Merit {
  double sum = 0.0;
  double beyond_limits = 0.0, dissent = 0.0;  ///< weighted metres, as MaximizeOverInterval has them
  double to_heaviest = 0.0;                   ///< distance from the heaviest peak's summit

  [[nodiscard]] bool IsBetterThan(const Merit& other) const {
    if (std::abs(sum - other.sum) > kLevel) return sum > other.sum;
    if (std::abs(beyond_limits - other.beyond_limits) > kLevel) {
      return beyond_limits < other.beyond_limits;
    }
    if (std::abs(dissent - other.dissent) > kLevel) return dissent < other.dissent;
    return to_heaviest < other.to_heaviest - kLevel;
  }
};

class PointSearch {
 public:
  PointSearch(std::span<const WeightedPeak> peaks, const MotionAxis& axis, MotionVariable variable)
      : peaks_(peaks), axis_(axis), variable_(variable) {}

  [[nodiscard]] double SumAt(double x) const {
    double sum = 0.0;
    for (const auto& [peak, weight] : peaks_) {
      sum += weight * PeakValue(peak, Away(x, peak.summit, variable_));
    }
    return sum;
  }
  [[nodiscard]] Merit MeritAt(double x) const {
    Merit merit{.sum = SumAt(x)};
    if (variable_ != MotionVariable::kCourse) {
      for (const auto& [peak, weight] : peaks_) {
        merit.beyond_limits += weight * BeyondLimit(peak, x, {axis_.low, axis_.high});
        merit.dissent += weight * BeyondTop(peak, x);
      }
    }
    const double heaviest =
        std::ranges::max_element(peaks_, {}, &WeightedPeak::weight)->peak.summit;
    merit.to_heaviest = Away(x, heaviest, variable_);
    return merit;
  }
  [[nodiscard]] double Best() const {
    double best = axis_.low;
    Merit best_merit = MeritAt(best);
    for (int i = 1; i < axis_.points; ++i) {
      if (const Merit merit = MeritAt(axis_.At(i)); merit.IsBetterThan(best_merit)) {
        best = axis_.At(i);
        best_merit = merit;
      }
    }
    return best;
  }

 private:
  std::span<const WeightedPeak> peaks_;
  const MotionAxis& axis_;
  MotionVariable variable_;
};

double NearestPoint(double value, const MotionAxis& axis, MotionVariable variable) {
  double nearest = axis.low;
  for (int i = 1; i < axis.points; ++i) {
    const double point = axis.At(i);
    if (Away(point, value, variable) < Away(nearest, value, variable) - kLevel) nearest = point;
  }
  return nearest;
}

}  // namespace

Peak StandingAtPoints(const Peak& peak, const MotionAxis& axis, MotionVariable variable) {
  Peak standing = peak;
  const double nearest = NearestPoint(peak.summit, axis, variable);
  if (PeakValue(peak, Away(nearest, peak.summit, variable)) <= 0.0) standing.summit = nearest;
  return standing;
}

double MaximizeOverPoints(std::span<const WeightedPeak> peaks, const MotionAxis& axis,
                          MotionVariable variable) {
  LIMPET_REQUIRE(!peaks.empty(), "a decision needs a preference");
  const double best = PointSearch(peaks, axis, variable).Best();
  return variable == MotionVariable::kCourse ? WrapAngle(best) : best;
}

}  // namespace limpet
