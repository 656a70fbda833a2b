// SPDX-License-Identifier: MIT
#include "estimation/change/contrast_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "estimation/change/log_space.hpp"
#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kBin = 0.25;  // [m]
/// Contrast has to be that many times what noise shows to be the ground's: noise is known no
/// better.
constexpr double kStandsOut = 2.0;
constexpr double kLeastNoise = 1e-5;
/// ln of the contrast that ground has close by, and its spread from site to site: real grounds had
/// 0.02 to 0.1 through a metre or two of water.
constexpr double kGround = -2.8, kGroundSpread = 0.7;
/// Spread of ln contrast from one distance to the next, for other ground, sun and tilt; and what
/// one distance is worth beside its neighbours, which show the same ground.
constexpr double kPatch = 0.35, kBinWorth = 0.5;
/// e-folds of contrast that are lost at the visibility: 5 % are left.
constexpr double kFolds = 3.0;

constexpr int kGrounds = 15;

double LogNormal(double x) { return -0.5 * x * x; }

/// ln of the chance that a standard normal variable is below x.
double LogCumulative(double x) {
  constexpr double kTail = -8.0;
  if (x < kTail) return LogNormal(x) - std::log(-x) - 0.5 * std::log(2.0 * std::numbers::pi);
  return std::log(StandardNormalShareBelow(x));
}

/// ln P of a bin where ln contrast is expected to be `expected`.
double OfBin(const ContrastBin& bin, double expected) {
  const double images = static_cast<double>(bin.clear) + bin.faint;
  double sum = 0.0;
  if (bin.clear > 0) {
    sum += bin.clear / images * LogNormal((bin.log_contrast - expected) / kPatch);
  }
  if (bin.faint > 0) {
    sum += bin.faint / images * LogCumulative((bin.log_limit - expected) / kPatch);
  }
  return kBinWorth * sum;
}

double Average(double average, double value, int count) {
  return average + (value - average) / count;
}

}  // namespace

ContrastBin& ContrastLog::BinAt(double range) {
  const double from = kBin * std::floor(range / kBin);
  const auto at = std::ranges::lower_bound(bins_, from, {}, &ContrastBin::from);
  if (at != bins_.end() && at->from == from) return *at;
  return *bins_.insert(at, ContrastBin{.from = from});
}

void ContrastLog::Set(std::vector<ContrastBin> bins) {
  std::erase_if(bins, [](const ContrastBin& bin) {
    return bin.clear < 0 || bin.faint < 0 || (bin.clear == 0 && bin.faint == 0);
  });
  std::ranges::sort(bins, {}, &ContrastBin::from);
  bins_ = std::move(bins);
}

void ContrastLog::Add(double range, const GroundContrast& image) {
  const double limit = kStandsOut * std::max(image.noise, kLeastNoise);
  if (!(range > 0.0) || !std::isfinite(range + image.green + limit)) {
    return;
  }
  ContrastBin& bin = BinAt(range);
  if (image.green > limit) {
    bin.log_contrast = Average(bin.log_contrast, std::log(image.green), ++bin.clear);
  } else {
    bin.log_limit = Average(bin.log_limit, std::log(limit), ++bin.faint);
  }
}

PerVisibility ContrastLog::LogLikelihood() const {
  PerVisibility total = 0.0;
  if (bins_.empty()) {
    return total;
  }
  for (int ground = 0; ground < kGrounds; ++ground) {
    constexpr double kReach = 3.0;  // standard deviations of the ground's contrast
    const double off = kReach * (2.0 * ground / (kGrounds - 1) - 1.0);
    PerVisibility of_ground = LogNormal(off);
    for (const ContrastBin& bin : bins_) {
      of_ground += VisibilityBelief::Grid().unaryExpr([&](double visibility) {
        const double range = bin.from + 0.5 * kBin;
        return OfBin(bin, kGround + kGroundSpread * off - kFolds * range / visibility);
      });
    }
    total = ground == 0 ? of_ground : LogSum(total, of_ground);
  }
  return total;
}

}  // namespace limpet
