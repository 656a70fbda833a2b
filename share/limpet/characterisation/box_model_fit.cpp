// SPDX-License-Identifier: MIT
#include "limpet/characterisation/box_model_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "limpet/core/logistic.hpp"
#include "limpet/core/require.hpp"
#include "limpet/core/statistics.hpp"

namespace limpet {
namespace {

using Looks = std::vector<TrialLook>;

template <class Keep>
Looks Where(const Looks& looks, const Keep& keep) {
  Looks kept;
  std::ranges::copy_if(looks, std::back_inserter(kept), keep);
  return kept;
}

double ShareFound(const Looks& looks) {
  const auto found =
      std::ranges::count_if(looks, [](const TrialLook& look) { return look.found.has_value(); });
  return static_cast<double>(found) / std::max(1.0, static_cast<double>(looks.size()));
}

/// Standard deviation of the normal distribution with the same 80 % of absolute values: some tail,
/// but no single blunder, counts.
double Spread(std::vector<double> errors) {
  for (double& error : errors)
    error = std::abs(error);
  return Quantile(std::move(errors), 0.8) / 1.2816;
}

template <class Value>
double MeanOf(const Looks& looks, const Value& value) {
  double sum = 0.0;
  for (const TrialLook& look : looks)
    sum += value(look);
  return sum / std::max(1.0, static_cast<double>(looks.size()));
}

double SquareRange(const TrialLook& look) { return look.range_share() * look.range_share(); }
double CutShare(const TrialLook& look) { return 1.0 - look.visible_fraction; }
double ConfidenceOf(const TrialLook& look) { return look.found->confidence; }

/// Errors of both coordinates of what was found.
std::vector<double> CentreErrors(const Looks& found) {
  std::vector<double> errors;
  for (const TrialLook& look : found) {
    errors.push_back(look.found->u - look.visible.center_u());
    errors.push_back(look.found->v - look.visible.center_v());
  }
  return errors;
}
std::vector<double> SizeErrors(const Looks& found, double bias) {
  std::vector<double> errors;
  for (const TrialLook& look : found) {
    errors.push_back(look.found->w - look.visible.width() - bias);
    errors.push_back(look.found->h - look.visible.height() - bias);
  }
  return errors;
}

/// Logistic curve peak / (1 + exp(-sign (value - middle) / width)).
struct Curve {
  double middle = 0.0, width = 0.0;
};
/// The curves among which one is looked for: their peak, which way they rise, and how far their
/// middles reach.
struct CurveFamily {
  double peak = 1.0, sign = 1.0, most = 1.0;
};
/// The one that makes what was found likeliest, from a grid of middles.
template <class Value>
Curve FitCurve(const Looks& looks, const CurveFamily& family, const Value& value) {
  constexpr int kMiddles = 200;
  constexpr int kWidths = 30;
  const auto [peak, sign, most] = family;
  Curve best{.middle = 0.0, .width = 0.05 * most};
  double best_likelihood = -1e300;
  for (int m = 0; m <= kMiddles; ++m) {
    for (int w = 1; w <= kWidths; ++w) {
      const Curve curve{.middle = most * m / kMiddles, .width = 0.15 * most * w / kWidths};
      double likelihood = 0.0;
      for (const TrialLook& look : looks) {
        const double p = std::clamp(
            peak * Logistic(sign * (value(look) - curve.middle) / curve.width), 1e-4, 1.0 - 1e-4);
        likelihood += std::log(look.found ? p : 1.0 - p);
      }
      if (likelihood > best_likelihood) best_likelihood = likelihood, best = curve;
    }
  }
  return best;
}

double ShareConfused(const Looks& found) {
  const auto wrong = std::ranges::count_if(
      found, [](const TrialLook& look) { return look.found->color != look.color; });
  return static_cast<double>(wrong) / std::max(1.0, static_cast<double>(found.size()));
}

bool IsNear(const TrialLook& look) { return look.range_share() < 0.5; }
bool IsWhole(const TrialLook& look) { return look.visible_fraction > 0.95; }
bool IsLarge(const TrialLook& look) { return look.size_px > 30.0; }
bool IsFound(const TrialLook& look) { return look.found.has_value(); }

void FitChances(const Looks& balls, BoxModelConstants& k) {
  const Looks large = Where(balls, IsLarge);
  const Looks clear =
      Where(large, [](const TrialLook& look) { return IsNear(look) && IsWhole(look); });
  k.peak = std::clamp(ShareFound(clear), 0.05, 0.999);
  const Curve faint = FitCurve(Where(large, IsWhole), {.peak = k.peak, .sign = -1.0, .most = 2.0},
                               [](const TrialLook& look) { return look.range_share(); });
  k.faint_at = faint.middle, k.faint_width = faint.width;
  const Curve cut = FitCurve(Where(large, IsNear), {.peak = k.peak},
                             [](const TrialLook& look) { return look.visible_fraction; });
  k.cut_at = cut.middle, k.cut_width = cut.width;
  const Curve small =
      FitCurve(Where(balls, [](const TrialLook& look) { return IsNear(look) && IsWhole(look); }),
               {.peak = k.peak, .most = 60.0}, [](const TrialLook& look) { return look.size_px; });
  k.least_radius_px = 0.5 * small.middle;
}

/// Spreads grow with the square of the range and as an object is cut; both are known at two means.
void FitSpreads(const Looks& found, BoxModelConstants& k) {
  const Looks near =
      Where(found, [](const TrialLook& look) { return IsNear(look) && IsWhole(look); });
  const Looks far =
      Where(found, [](const TrialLook& look) { return !IsNear(look) && IsWhole(look); });
  const Looks cut = Where(
      found, [](const TrialLook& look) { return IsNear(look) && look.visible_fraction < 0.8; });
  const double near2 = MeanOf(near, SquareRange);
  const double far2 = MeanOf(far, SquareRange);
  const double centre = std::max(Spread(CentreErrors(near)), 1e-3);
  k.size_bias_px = Quantile(SizeErrors(near, 0.0), 0.5);
  const double growth = far.empty() ? 1.0 : Spread(CentreErrors(far)) / centre;
  k.sd_growth_faint = std::max(0.0, (growth - 1.0) / std::max(far2 - growth * near2, 1e-3));
  const double scale = 1.0 + k.sd_growth_faint * near2;
  k.centre_sd_px = centre / scale;
  k.size_sd_px = Spread(SizeErrors(near, k.size_bias_px)) / scale;
  const double cut_share = std::max(MeanOf(cut, CutShare), 1e-3);
  k.sd_growth_cut =
      cut.empty() ? 0.0 : std::max(0.0, (Spread(CentreErrors(cut)) / centre - 1.0) / cut_share);
  k.confidence = MeanOf(near, ConfidenceOf);
  k.confidence_loss_faint = far.empty() ? 0.0
                                        : std::max(0.0, (k.confidence - MeanOf(far, ConfidenceOf)) /
                                                            std::max(far2 - near2, 1e-3));
  k.confidence_loss_cut =
      cut.empty() ? 0.0 : std::max(0.0, (k.confidence - MeanOf(cut, ConfidenceOf)) / cut_share);
  const double mean = k.confidence;
  k.confidence_sd = std::sqrt(MeanOf(near, [mean](const TrialLook& look) {
    return std::pow(look.found->confidence - mean, 2.0);
  }));
  k.confusion_whole = ShareConfused(near);
  k.confusion_cut = std::max(k.confusion_whole, ShareConfused(cut));
}

/// Of two sessions that name different colours: -2 ln of how much likelier that is if they mean two
/// objects than if one of them is wrong about the same. One water, one light: within a session a
/// wrong colour is wrong in all looks.
double ColorPenalty(double wrong_color) {
  constexpr double kOthersDiffer = 0.5;  // two objects, two colours
  constexpr double kMost = 30.0;
  const double differ = 2.0 * wrong_color * (1.0 - wrong_color);
  return std::clamp(-2.0 * std::log(differ / kOthersDiffer), 0.0, kMost);
}

}  // namespace

BoxModelConstants FitBoxModel(const TrialResult& trial) {
  const Looks balls =
      Where(trial.looks, [](const TrialLook& look) { return look.kind == SolidKind::kSphere; });
  const Looks found = Where(balls, IsFound);
  LIMPET_REQUIRE(!found.empty(), "a detector that finds nothing has no model");
  BoxModelConstants constants;
  FitChances(balls, constants);
  FitSpreads(found, constants);
  return constants;
}

DetectionSheet SheetOf(const BoxModelConstants& boxes, const TrialResult& trial) {
  constexpr double kMargin = 0.975;      // of the chance close by
  constexpr double kRangeMargin = 0.85;  // of the range
  constexpr double kFalseMargin = 3.0;   // a sea has more that looks like a ball than renderings
  constexpr double kLeastFalse = 0.01;
  constexpr double kLeastWrong = 0.01;
  constexpr double kMostWrong = 0.4;
  const double false_boxes = static_cast<double>(trial.false_boxes) / std::max(1, trial.pictures);
  const double wrong_color = std::clamp(boxes.confusion_whole, kLeastWrong, kMostWrong);
  return {
      .detection = {.best = kMargin * boxes.peak,
                    .half_range = kRangeMargin * boxes.faint_at,
                    .fall_off = std::max(boxes.faint_width, 0.03),
                    .least_size_px = 2.0 * boxes.least_radius_px,
                    .share_none = std::clamp(boxes.cut_at - boxes.cut_width, 0.0, 0.8),
                    .share_full = std::clamp(boxes.cut_at + 3.5 * boxes.cut_width, 0.1, 1.0),
                    .false_per_image = std::clamp(kFalseMargin * false_boxes, kLeastFalse, 1.0)},
      .wrong_color = wrong_color,
      .color_penalty = ColorPenalty(wrong_color)};
}

}  // namespace limpet
