// SPDX-License-Identifier: MIT
// Simulated places whose fate is known, seen by passes that fail as a whole now and then: to ask
// whether the posterior means what it says.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "estimation/change/look_log.hpp"
#include "estimation/change/status.hpp"
#include "limpet/core/random.hpp"

namespace limpet::trial {

/// How the world really is, which the estimator does not know exactly.
struct ChangeWorld {
  double presence = 0.3;  ///< places that had an object in the former session
  double survival = 0.5;
  double appearance = 0.3;
  double detects = 0.9;          ///< mean chance per frame, as the estimator believes
  double rate_factor = 1.0;      ///< true rate over believed rate
  double pass_spread = 0.1;      ///< standard deviation of the rate from pass to pass
  double pass_failure = 0.02;    ///< passes that see next to nothing of what is there
  double place_failure = 0.005;  ///< sessions in which no pass sees what is there
  double lookalike = 5e-5;       ///< empty places with something that looks like an object
  double false_alarm = 0.003;    ///< per frame
  int passes_max = 3;
  int looks_max = 6;
  int frames_per_look = 4;
};

enum class Fate { kConfirmed, kRemoved, kNew, kNothing };

/// What one session's passes over one place say.
inline PlaceEvidence SimulateSession(const ChangeWorld& world, bool is_present,
                                     const LookParams& params, Random& random) {
  LookLog log(params);
  const bool is_overgrown = random.Chance(world.place_failure);
  const double clutter = random.Chance(world.lookalike) ? 0.7 : 0.0;
  const int passes =
      1 + static_cast<int>(random.Index(static_cast<std::uint64_t>(world.passes_max)));
  double time = 0.0;
  for (int pass = 0; pass < passes; ++pass, time += 60.0) {
    double rate = world.detects * world.rate_factor + random.Normal(world.pass_spread);
    if (is_overgrown || random.Chance(world.pass_failure)) rate *= 0.05;
    const double chance = is_present ? rate : std::max(world.false_alarm, clutter);
    const int looks =
        1 + static_cast<int>(random.Index(static_cast<std::uint64_t>(world.looks_max)));
    for (int i = 0; i < looks * world.frames_per_look; ++i, time += 0.25) {
      log.Add({.time = time,
               .p_OC = {0.5 * i / world.frames_per_look - 1.0, 0.3, -3.0},
               .detects = world.detects,
               .false_alarm = world.false_alarm,
               .has_box = random.Chance(std::min(std::max(chance, 0.0), 1.0))});
    }
  }
  return log.evidence();
}

/// Squared error and calibration of the probability of one status.
struct Calibration {
  double brier = 0.0;
  double expected_error = 0.0;  ///< ECE over ten bins
};

/// Over `places` simulated places, per status (confirmed, removed, new, nothing).
inline std::array<Calibration, 4> Calibrate(const ChangeWorld& world, const LookParams& params,
                                            int places, Random& random) {
  const StatusPriors priors{
      .presence = world.presence, .survival = world.survival, .appearance = world.appearance};
  const VisibilityBelief water(Meters(8.0), 2.0);
  constexpr int kBins = 10;
  struct Bin {
    double probability = 0.0, outcome = 0.0;
  };
  std::array<std::array<Bin, kBins>, 4> bins{};
  std::array<Calibration, 4> result;
  for (int i = 0; i < places; ++i) {
    const bool was = random.Chance(world.presence);
    const bool is = random.Chance(was ? world.survival : world.appearance);
    const PlaceEvidence former = SimulateSession(world, was, params, random);
    const PlaceEvidence now = SimulateSession(world, is, params, random);
    const StatusPosterior p = ChangeStatus(former.Lambda(priors.lookalike)(0), now, water, priors);
    const std::array<double, 4> says{p.confirmed, p.removed, p.appeared, p.nothing};
    const Fate fate =
        was ? (is ? Fate::kConfirmed : Fate::kRemoved) : (is ? Fate::kNew : Fate::kNothing);
    for (std::size_t s = 0; s < says.size(); ++s) {
      const double outcome = static_cast<std::size_t>(fate) == s ? 1.0 : 0.0;
      result[s].brier += std::pow(says[s] - outcome, 2) / places;
      Bin& bin = bins[s][static_cast<std::size_t>(std::min(says[s] * kBins, kBins - 1.0))];
      bin.probability += says[s] / places;
      bin.outcome += outcome / places;
    }
  }
  for (std::size_t s = 0; s < bins.size(); ++s) {
    for (const Bin& bin : bins[s]) {
      result[s].expected_error += std::abs(bin.probability - bin.outcome);
    }
  }
  return result;
}

}  // namespace limpet::trial
