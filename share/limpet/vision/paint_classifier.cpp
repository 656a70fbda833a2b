// SPDX-License-Identifier: MIT
#include "limpet/vision/paint_classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "limpet/core/interval.hpp"

namespace limpet {
namespace {

constexpr double kMargin = 0.15;

/// How far `value` lies inside `range`, as a share of the margin; negative outside.
double Inside(double value, const Interval& range) {
  return std::min(value - range.low, range.high - value) / kMargin;
}

/// Certainty of each paint is that of its least certain condition.
struct Rule {
  const char* color;
  double certainty;
};

}  // namespace

std::optional<PaintClass> ClassifyPaint(const Eigen::Vector3d& difference) {
  // In units of the greatest: haze scales all three, red a little more.
  const Eigen::Vector3d d = difference / std::max(difference.cwiseAbs().maxCoeff(), 1e-6);
  const double b = d(0);
  const double g = d(1);
  const double r = d(2);
  const std::array<Rule, 7> rules{{
      {"yellow", std::min({Inside(g - 0.24 * r, {0.0, 1.0}), Inside(r - 0.95 * g, {0.0, 1.0}),
                           Inside(b - 0.25 * g, {-2.0, 0.0})})},
      {"orange",
       std::min({Inside(g, {-0.30, 0.24}), Inside(r, {0.6, 2.0}), Inside(b, {-2.0, 0.0})})},
      {"red", std::min({Inside(g, {-2.0, -0.30}), Inside(r, {0.4, 2.0}), Inside(b, {-2.0, 0.0})})},
      {"green", std::min({Inside(g, {0.6, 2.0}), Inside(r - 0.95 * g, {-3.0, 0.0}),
                          Inside(b - 0.40 * g, {-3.0, 0.0})})},
      {"purple",
       std::min({Inside(b, {0.3, 2.0}), Inside(r, {0.15, 2.0}), Inside(g, {-2.0, -0.1})})},
      {"white", Inside(std::min({b, g, r}), {0.55, 2.0})},
      {"blue", std::min(Inside(b, {0.6, 2.0}), Inside(std::max(g, r), {-2.0, 0.1}))},
  }};
  const Rule& best = *std::ranges::max_element(rules, {}, &Rule::certainty);
  if (best.certainty <= 0.0) {
    return std::nullopt;
  }
  return PaintClass{best.color, std::min(best.certainty, 1.0)};
}

}  // namespace limpet
