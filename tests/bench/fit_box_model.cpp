// SPDX-License-Identifier: MIT
// Renders random frames, runs the detector, and prints the constants of BoxModelConstants that
// describe what it achieved. Usage: fit_box_model [scenes of 20 frames, default 150] [seed]
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>

#include "tests/support/detector_trial.hpp"

namespace limpet {
namespace {

using trial::Look;
using Looks = std::vector<Look>;

Looks Where(const Looks& looks, const std::function<bool(const Look&)>& keep) {
  Looks kept;
  std::ranges::copy_if(looks, std::back_inserter(kept), keep);
  return kept;
}

double ShareFound(const Looks& looks) {
  const auto found =
      std::ranges::count_if(looks, [](const Look& look) { return look.found.has_value(); });
  return static_cast<double>(found) / std::max(1.0, static_cast<double>(looks.size()));
}

double Logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// Middle and width of the logistic curve in `value` that makes what was found likeliest.
struct Curve {
  double middle = 0.0, width = 0.0;
};
Curve FitLogistic(const Looks& looks, double peak, double sign,
                  const std::function<double(const Look&)>& value) {
  Curve best;
  double best_likelihood = -1e300;
  for (double middle = 0.0; middle <= 2.0; middle += 0.01) {
    for (double width = 0.01; width <= 0.3; width += 0.01) {
      double likelihood = 0.0;
      for (const Look& look : looks) {
        const double p =
            std::clamp(peak * Logistic(sign * (value(look) - middle) / width), 1e-4, 1.0 - 1e-4);
        likelihood += std::log(look.found ? p : 1.0 - p);
      }
      if (likelihood > best_likelihood) {
        best_likelihood = likelihood;
        best = {middle, width};
      }
    }
  }
  return best;
}

/// Standard deviation of the normal distribution with the same 80 % of absolute values: some tail,
/// but no single blunder, counts.
double Spread(std::vector<double> errors) {
  if (errors.empty()) {
    return 0.0;
  }
  for (double& error : errors) {
    error = std::abs(error);
  }
  const auto place = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 4 / 5);
  std::ranges::nth_element(errors, place);
  return *place / 1.2816;
}

double Median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::vector<double> CentreErrors(const Looks& looks) {
  std::vector<double> errors;
  for (const Look& look : looks) {
    if (look.found) {
      errors.push_back(look.found->u - look.image.visible.center_u());
      errors.push_back(look.found->v - look.image.visible.center_v());
    }
  }
  return errors;
}

std::vector<double> SizeErrors(const Looks& looks, double bias) {
  std::vector<double> errors;
  for (const Look& look : looks) {
    if (look.found) {
      errors.push_back(look.found->w - look.image.visible.width() - bias);
      errors.push_back(look.found->h - look.image.visible.height() - bias);
    }
  }
  return errors;
}

std::vector<double> Confidences(const Looks& looks) {
  std::vector<double> values;
  for (const Look& look : looks) {
    if (look.found) {
      values.push_back(look.found->confidence);
    }
  }
  return values;
}

double Mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / std::max(1.0, static_cast<double>(values.size()));
}

double ShareConfused(const Looks& looks) {
  const Looks found = Where(looks, [](const Look& look) { return look.found.has_value(); });
  const auto wrong = std::ranges::count_if(
      found, [](const Look& look) { return look.found->color != look.color; });
  return static_cast<double>(wrong) / std::max(1.0, static_cast<double>(found.size()));
}

/// Mean of `value` over the looks.
double MeanOf(const Looks& looks, const std::function<double(const Look&)>& value) {
  double sum = 0.0;
  for (const Look& look : looks) {
    sum += value(look);
  }
  return sum / std::max(1.0, static_cast<double>(looks.size()));
}

void Print(const trial::Result& result) {
  const auto range_share = [](const Look& look) { return look.range_share(); };
  const auto visible = [](const Look& look) { return look.image.visible_fraction; };
  const auto square_range = [](const Look& look) {
    return look.range_share() * look.range_share();
  };
  const auto cut_share = [](const Look& look) { return 1.0 - look.image.visible_fraction; };
  const Looks clear = Where(result.looks, [](const Look& look) {
    return look.range_share() < 0.6 && look.image.visible_fraction > 0.9;
  });
  const Looks whole =
      Where(result.looks, [](const Look& look) { return look.image.visible_fraction > 0.99; });
  const Looks near = Where(result.looks, [](const Look& look) { return look.range_share() < 0.6; });
  const Looks near_whole = Where(whole, [](const Look& look) { return look.range_share() < 0.5; });
  const Looks far_whole = Where(
      whole, [](const Look& look) { return look.range_share() > 0.6 && look.range_share() < 1.0; });
  const Looks cut = Where(near, [](const Look& look) {
    return look.image.visible_fraction > 0.3 && look.image.visible_fraction < 0.8;
  });
  const Looks mostly_hidden =
      Where(near, [](const Look& look) { return look.image.visible_fraction < 0.5; });

  const double peak = std::min(ShareFound(clear), 0.999);
  const Curve faint = FitLogistic(whole, peak, -1.0, range_share);
  const Curve cut_curve = FitLogistic(near, peak, 1.0, visible);
  const double bias = Median(SizeErrors(near_whole, 0.0));
  const double centre = Spread(CentreErrors(near_whole));
  const double size = Spread(SizeErrors(near_whole, bias));
  const double far_growth = Spread(CentreErrors(far_whole)) / centre;
  const double near2 = MeanOf(near_whole, square_range);
  const double far2 = MeanOf(far_whole, square_range);
  // sd = sd0 (1 + growth x^2), known at two mean squares of x.
  const double growth = std::max(0.0, (far_growth - 1.0) / (far2 - far_growth * near2));
  const double scale = 1.0 + growth * near2;
  const double cut_growth =
      std::max(0.0, (Spread(CentreErrors(cut)) / centre - 1.0) / MeanOf(cut, cut_share));
  const double confidence = Mean(Confidences(near_whole));
  const double confidence_faint = (confidence - Mean(Confidences(far_whole))) / (far2 - near2);
  const double confidence_cut = (confidence - Mean(Confidences(cut))) / MeanOf(cut, cut_share);
  const double cut2 =
      MeanOf(Where(mostly_hidden, [](const Look& look) { return look.found.has_value(); }),
             [](const Look& look) { return std::pow(1.0 - look.image.visible_fraction, 2.0); });

  fmt::print("// {} frames, {} looks\n", result.frames, result.looks.size());
  fmt::print("double peak = {:.4f};\n", peak);
  fmt::print("double faint_at = {:.3f};\ndouble faint_width = {:.3f};\n", faint.middle,
             faint.width);
  fmt::print("double cut_at = {:.3f};\ndouble cut_width = {:.3f};\n", cut_curve.middle,
             cut_curve.width);
  fmt::print("double centre_sd_px = {:.3f};\n", centre / scale);
  fmt::print("double size_sd_px = {:.3f};\ndouble size_bias_px = {:.3f};\n", size / scale, bias);
  fmt::print("double sd_growth_faint = {:.2f};\ndouble sd_growth_cut = {:.2f};\n", growth,
             cut_growth);
  fmt::print("double confidence = {:.3f};\n", confidence);
  fmt::print("double confidence_loss_faint = {:.3f};\n", std::max(0.0, confidence_faint));
  fmt::print("double confidence_loss_cut = {:.3f};\n", std::max(0.0, confidence_cut));
  fmt::print("double confusion_whole = {:.4f};\n", ShareConfused(clear));
  fmt::print("double confusion_cut = {:.3f};\n",
             std::min(1.0, ShareConfused(mostly_hidden) / std::max(cut2, 1e-3)));
  fmt::print("// false boxes per image: {:.4f}\n",
             static_cast<double>(result.false_boxes) / result.frames);
  const Looks scored = Where(result.looks, [](const Look& look) {
    return look.range_share() < 1.0 && look.image.visible_fraction >= 0.6;
  });
  fmt::print("// recall within the visibility, at least 60 % visible: {:.4f} of {}\n",
             ShareFound(scored), scored.size());
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  limpet::trial::Plan plan{.scenes = 150, .frames = 20, .least_visibility_m = 2.5};
  if (argc > 1) plan.scenes = std::max(1, std::atoi(argv[1]));
  if (argc > 2) plan.seed = static_cast<std::uint64_t>(std::max(1, std::atoi(argv[2])));
  limpet::Print(limpet::trial::RunDetector(plan));
  return 0;
}
