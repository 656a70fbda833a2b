// SPDX-License-Identifier: MIT
#include "limpet/survey/visibility_belief.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Chance that the water is as nobody expected; spread over all visibilities alike.
constexpr double kUnexpected = 0.01;

PerVisibility Logarithms() {
  return VisibilityBelief::Grid().unaryExpr([](double v) { return std::log(v); });
}

}  // namespace

const PerVisibility& VisibilityBelief::Grid() {
  static const PerVisibility grid = [] {
    PerVisibility visibilities;
    for (int i = 0; i < PerVisibility::kCount; ++i) {
      const double share = static_cast<double>(i) / (PerVisibility::kCount - 1);
      visibilities(i) = kLeast_m * std::pow(kMost_m / kLeast_m, share);
    }
    return visibilities;
  }();
  return grid;
}

VisibilityBelief::VisibilityBelief(Meters expected, double spread) {
  LIMPET_REQUIRE(expected.value() > 0.0 && spread > 1.0, "not a spread about a visibility");
  const PerVisibility off = (Logarithms() - std::log(expected.value())) / std::log(spread);
  chances_ = off.unaryExpr([](double x) { return std::exp(-0.5 * x * x); });
  const double sum = chances_.sum();
  if (sum > 0.0) {
    chances_ = (1.0 - kUnexpected) * chances_ / sum;
  }
  chances_ += kUnexpected / PerVisibility::kCount;
  chances_ /= chances_.sum();
}

VisibilityBelief VisibilityBelief::Of(const WaterVisibility& estimate) {
  constexpr double kLeastSpread = 0.1;  // of the logarithm: between two of the grid
  const double all = estimate.sd / estimate.visibility;
  const double own = std::sqrt(std::max(all * all - kDetectorSpread * kDetectorSpread, 0.0));
  return {estimate.visibility, std::exp(std::max(own, kLeastSpread))};
}

void VisibilityBelief::Add(const PerVisibility& log_likelihood, double most) {
  const double best = log_likelihood.maxCoeff();
  chances_ *= log_likelihood.unaryExpr(
      [best, most](double value) { return std::exp(std::max(value - best, -most)); });
  chances_ /= chances_.sum();
}

WaterVisibility VisibilityBelief::estimate() const {
  const PerVisibility logarithms = Logarithms();
  const double mean = Expect(logarithms);
  const double variance = Expect((logarithms - mean).square());
  const double visibility = std::exp(mean);
  return {.visibility = Meters(visibility),
          .sd = Meters(visibility * std::hypot(std::sqrt(variance), kDetectorSpread))};
}

}  // namespace limpet
