// SPDX-License-Identifier: MIT
#include "limpet/tuning/bayes_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/core/random.hpp"
#include "limpet/tuning/gaussian_process.hpp"

namespace limpet {
namespace {

constexpr int kPlacesTried = 2000;
constexpr int kPlacesNearBest = 200;
constexpr double kNear = 0.05;  // in shares of each range, one sigma

/// Variance of one paired difference, over all contenders; 0 if none has two.
double PooledVariance(const std::vector<Contender>& flown) {
  double squares = 0.0, degrees = 0.0;
  for (const Contender& contender : flown) {
    const std::vector<double> differences = PairedDifferences(contender, flown.front());
    if (contender.is_default || differences.size() < 2) continue;
    const auto count = static_cast<double>(differences.size());
    const double error = IntervalOf(differences).standard_error;
    squares += error * error * count * (count - 1.0);
    degrees += count - 1.0;
  }
  return degrees > 0.0 ? squares / degrees : 0.0;
}

std::vector<ProcessSample> SamplesOf(const ParameterSpace& space,
                                     const std::vector<Contender>& flown) {
  const double variance = PooledVariance(flown);
  std::vector<ProcessSample> samples;
  std::vector<const Contender*> breakers;
  double worst = 0.0;
  for (const Contender& contender : flown) {
    const std::vector<double> differences = PairedDifferences(contender, flown.front());
    const bool breaks =
        !contender.is_default && 2 * contender.Failures() > contender.outcomes.size();
    if (differences.empty() || breaks) {
      breakers.push_back(&contender);
      continue;
    }
    const double mean = IntervalOf(differences).mean;
    worst = std::max(worst, mean);
    samples.push_back({.x = space.SharesOf(contender.setting),
                       .y = mean,
                       .variance = contender.is_default
                                       ? 0.0
                                       : variance / static_cast<double>(differences.size())});
  }
  for (const Contender* breaker : breakers)
    samples.push_back({.x = space.SharesOf(breaker->setting), .y = worst, .variance = variance});
  return samples;
}

bool IsTried(const std::vector<Contender>& flown, const std::vector<SettingValues>& chosen,
             const SettingValues& setting) {
  return std::ranges::find(flown, setting, &Contender::setting) != flown.end() ||
         std::ranges::find(chosen, setting) != chosen.end();
}

/// Places all over the space and around the best.
std::vector<SettingValues> Places(const ParameterSpace& space, const Eigen::VectorXd& best,
                                  std::uint64_t seed) {
  std::vector<SettingValues> places = space.Spread(kPlacesTried, seed);
  Random random(seed, "near the best");
  for (int i = 0; i < kPlacesNearBest; ++i) {
    Eigen::VectorXd near = best;
    for (double& share : near)
      share += random.Normal(kNear);
    places.push_back(space.At(near));
  }
  return places;
}

const ProcessSample& LeastOf(const std::vector<ProcessSample>& samples) {
  return *std::ranges::min_element(samples, {}, &ProcessSample::y);
}

}  // namespace

std::vector<SettingValues> MostPromising(const ParameterSpace& space,
                                         const std::vector<Contender>& flown, int count,
                                         std::uint64_t seed) {
  std::vector<ProcessSample> samples = SamplesOf(space, flown);
  std::vector<SettingValues> chosen;
  const ProcessShape shape = GaussianProcess::Fitted(samples).shape();
  for (int i = 0; i < count; ++i) {
    const GaussianProcess process(samples, shape);
    // The best prediction at a place that was flown: the least measured value may be luck.
    double least = std::numeric_limits<double>::infinity();
    for (const ProcessSample& sample : samples)
      least = std::min(least, process.At(sample.x).mean);
    const SettingValues* next = nullptr;
    double greatest = -1.0;
    const std::vector<SettingValues> places =
        Places(space, LeastOf(samples).x, MixSeed(seed, "places " + std::to_string(i)));
    for (const SettingValues& place : places) {
      if (IsTried(flown, chosen, place)) continue;
      const double gain = ExpectedImprovement(process.At(space.SharesOf(place)), least);
      if (gain > greatest) {
        greatest = gain;
        next = &place;
      }
    }
    if (next == nullptr) break;
    chosen.push_back(*next);
    const Eigen::VectorXd x = space.SharesOf(*next);
    samples.push_back({.x = x, .y = process.At(x).mean, .variance = 0.0});
  }
  return chosen;
}

}  // namespace limpet
