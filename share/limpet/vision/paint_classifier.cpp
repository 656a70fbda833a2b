// SPDX-License-Identifier: MIT
#include "limpet/vision/paint_classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limpet {
namespace {

/// How far `value` lies inside [low, high], as a share of `margin`; negative outside.
double Inside(double value, double low, double high, double margin) {
  return std::min(value - low, high - value) / margin;
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
  constexpr double kMargin = 0.15;
  const std::array<Rule, 7> rules{{
      {"yellow",
       std::min({Inside(g - 0.24 * r, 0.0, 1.0, kMargin), Inside(r - 0.95 * g, 0.0, 1.0, kMargin),
                 Inside(b - 0.25 * g, -2.0, 0.0, kMargin)})},
      {"orange", std::min({Inside(g, -0.30, 0.24, kMargin), Inside(r, 0.6, 2.0, kMargin),
                           Inside(b, -2.0, 0.0, kMargin)})},
      {"red", std::min({Inside(g, -2.0, -0.30, kMargin), Inside(r, 0.4, 2.0, kMargin),
                        Inside(b, -2.0, 0.0, kMargin)})},
      {"green", std::min({Inside(g, 0.6, 2.0, kMargin), Inside(r - 0.95 * g, -3.0, 0.0, kMargin),
                          Inside(b - 0.40 * g, -3.0, 0.0, kMargin)})},
      {"purple", std::min({Inside(b, 0.3, 2.0, kMargin), Inside(r, 0.15, 2.0, kMargin),
                           Inside(g, -2.0, -0.1, kMargin)})},
      {"white", Inside(std::min({b, g, r}), 0.55, 2.0, kMargin)},
      {"blue", std::min(Inside(b, 0.6, 2.0, kMargin), Inside(std::max(g, r), -2.0, 0.1, kMargin))},
  }};
  const Rule& best = *std::ranges::max_element(rules, {}, &Rule::certainty);
  if (best.certainty <= 0.0) {
    return std::nullopt;
  }
  return PaintClass{best.color, std::min(best.certainty, 1.0)};
}

}  // namespace limpet
