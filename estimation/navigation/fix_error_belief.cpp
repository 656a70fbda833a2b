// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_error_belief.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr int kScales = 12, kNoises = 13;  // each sqrt(2) times the one before
constexpr double kLeastScale = 0.5, kLeastNoise = 0.07;
constexpr double kUsualSpread = 0.35;  // of the logarithm of the scale: a factor of two in 95 %
constexpr double kUnusualShare = 0.05;
struct Duration {
  double factor, share;
};
constexpr Duration kDurations[] = {{0.5, 0.25}, {1.0, 0.4}, {2.0, 0.25}, {8.0, 0.06}, {32.0, 0.04}};
// Errors of receivers are no Gauss-Markov process but something like it: a fix says half of what it
// would. What one stay says against all else does not hang on that.
constexpr double kFixWeight = 0.5;
constexpr double kMostOfStart = 25.0;    // squared: then dead reckoning is what is wrong
constexpr double kAsStated = 1.3;        // squared: no more than such an estimate scatters by
constexpr double kAnywhere = 1e4;        // [m^2]
constexpr double kMostNoiseShare = 0.5;  // of the stated variance
constexpr double kSlightest = 1e-8;

/// Twice the negative logarithm of both axes' density, but for what all share.
double Surprise(const Eigen::Vector2d& off, double variance, double most) {
  return 2.0 * std::log(variance) + std::min(off.squaredNorm() / variance, most);
}

double UsualPrior(double scale) {
  // The mean square of all usual errors is what is stated.
  const double z = (std::log(scale) + kUsualSpread * kUsualSpread) / kUsualSpread;
  return std::exp(-0.5 * z * z);
}

}  // namespace

double FixErrorBelief::Hypothesis::WanderShare() const {
  const double all = scale * scale;
  return all - std::min(noise * noise, kMostNoiseShare * all);
}

FixErrorBelief::FixErrorBelief(Seconds correlation) {
  std::vector<double> scales, usual;
  double usual_sum = 0.0;
  for (int i = 0; i < kScales; ++i) {
    scales.push_back(kLeastScale * std::exp2(0.5 * i));
    usual.push_back(UsualPrior(scales.back()));
    usual_sum += usual.back();
  }
  const auto larger = std::ranges::count_if(scales, [](double scale) { return scale > 1.0; });
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double unusual = scales[i] > 1.0 ? kUnusualShare / static_cast<double>(larger) : 0.0;
    const double prior = (1.0 - kUnusualShare) * usual[i] / usual_sum + unusual;
    for (const auto& [factor, share] : kDurations) {
      for (int noise = 0; noise < kNoises; ++noise) {
        const double weight = std::log(prior * share);
        hypotheses_.push_back({.scale = scales[i],
                               .noise = kLeastNoise * std::exp2(0.5 * noise),
                               .correlation = factor * correlation.value(),
                               .log_before = weight,
                               .log_weight = weight});
      }
    }
  }
}

void FixErrorBelief::BeginStay(const std::optional<Start>& start) {
  start_ = start;
  last_t_.reset();
  for (Hypothesis& hypothesis : hypotheses_)
    hypothesis.log_before = hypothesis.log_weight;
}

void FixErrorBelief::RestartStay() {
  last_t_.reset();
  for (Hypothesis& hypothesis : hypotheses_)
    hypothesis.log_weight = hypothesis.log_before;
}

void FixErrorBelief::Begin(Hypothesis& hypothesis, const Fix& fix) const {
  hypothesis.wander_W.setZero();
  hypothesis.wander_variance = hypothesis.WanderShare() * fix.sd * fix.sd;
  hypothesis.between = 0.0;
  hypothesis.place_W = fix.off_W - (start_ ? start_->off_W : Eigen::Vector2d::Zero());
  hypothesis.place_variance = start_ ? start_->variance : kAnywhere;
}

void FixErrorBelief::Use(Hypothesis& h, const Fix& fix, double seconds) const {
  const double stated = fix.sd * fix.sd, keep = std::exp(-seconds / h.correlation);
  h.wander_W *= keep;
  h.wander_variance =
      keep * keep * h.wander_variance + (1.0 - keep * keep) * h.WanderShare() * stated;
  h.between *= keep;
  h.place_variance += fix.drift;
  const double by_wander = h.wander_variance + h.between, by_place = h.between + h.place_variance;
  const double variance = by_wander + by_place + h.noise * h.noise * stated + kSlightest;
  const Eigen::Vector2d off = fix.off_W - h.wander_W - h.place_W;
  h.log_weight -= last_t_ ? 0.5 * kFixWeight * Surprise(off, variance, 1e9)
                          : 0.5 * Surprise(off, variance, kMostOfStart);
  h.wander_W += by_wander / variance * off;
  h.place_W += by_place / variance * off;
  h.wander_variance -= by_wander * by_wander / variance;
  h.place_variance -= by_place * by_place / variance;
  h.between -= by_wander * by_place / variance;
}

void FixErrorBelief::Add(const Fix& fix) {
  const double seconds = last_t_ ? std::max(fix.t - *last_t_, 0.0) : 0.0;
  for (Hypothesis& hypothesis : hypotheses_) {
    if (!last_t_) Begin(hypothesis, fix);
    Use(hypothesis, fix, seconds);
  }
  last_t_ = fix.t;
}

template <typename Value>
double FixErrorBelief::Mean(const Value& value) const {
  const double most =
      std::ranges::max_element(hypotheses_, {}, &Hypothesis::log_weight)->log_weight;
  double sum = 0.0, weights = 0.0;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const double weight = std::exp(hypothesis.log_weight - most);
    weights += weight;
    sum += weight * value(hypothesis);
  }
  return sum / weights;
}

double FixErrorBelief::Scale() const {
  const double all = Mean([](const Hypothesis& h) { return h.scale * h.scale; });
  const double wander = Mean([](const Hypothesis& h) { return h.WanderShare(); });
  if (all > kAsStated) return std::sqrt(wander);
  return std::sqrt(1.0 - std::min(all - wander, kMostNoiseShare));
}

FixErrorBelief::Ratio FixErrorBelief::ratio() const {
  const double mean = Mean([](const Hypothesis& h) { return h.scale; });
  const double square = Mean([](const Hypothesis& h) { return h.scale * h.scale; });
  return {.mean = mean, .sd = std::sqrt(std::max(square - mean * mean, 0.0))};
}

}  // namespace limpet
