// SPDX-License-Identifier: MIT
#include "limpet/vision/paint_classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "limpet/core/interval.hpp"

namespace limpet {
namespace {

constexpr double kMargin = 0.15;

// Of rendered rims at a visibility of 3 to 12 m, 98 of 100: red below 0.05, orange 0.09 to 0.38,
// yellow from 0.46.
constexpr double kRedBelow = 0.06, kYellowFrom = 0.41, kWarmMargin = 0.04;
constexpr double kLeastWarmth = 0.05;  // of Weber's contrast, red less blue: what noise may make
constexpr double kGamma = 2.2;         // of cameras: light is level to this power

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

bool IsWarm(const PaintClass& paint) {
  return paint.color == "yellow" || paint.color == "orange" || paint.color == "red";
}

std::optional<PaintClass> ClassifyWarmInShade(const Eigen::Vector3d& inside,
                                              const Eigen::Vector3d& outside) {
  const Eigen::Array3d ground = outside.array().max(1.0).pow(kGamma);
  const Eigen::Array3d weber = inside.array().max(0.0).pow(kGamma) / ground;
  const double warmth = weber(2) - weber(0);
  if (warmth < kLeastWarmth) return std::nullopt;
  const double ratio = (weber(1) - weber(0)) / warmth * std::sqrt(ground(1) / ground(2));
  const double off = std::min(std::abs(ratio - kRedBelow), std::abs(ratio - kYellowFrom));
  const char* color = ratio < kRedBelow ? "red" : ratio < kYellowFrom ? "orange" : "yellow";
  return PaintClass{color, std::min(off / kWarmMargin, 1.0)};
}

}  // namespace limpet
