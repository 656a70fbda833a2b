// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limpet/tuning/race.hpp"

namespace limpet {

struct TuningRules {
  std::string method = "grid";  ///< grid, random, bayes
  int settings = 20;            ///< how many random and bayes try
  std::size_t runs = 10;        ///< seeds of the search, and as many held out
  double share = 0.9;           ///< of runs that must keep the constraints
  std::uint64_t seed = 1;       ///< of the method's draws
};

/// A setting on seeds that the search has not seen.
struct HeldOut {
  Contender by_default, winner;
  std::vector<double> differences{};  ///< winner less default, by seed
};

/// What a search came to. Costs are to be minimised.
struct TuningOutcome {
  std::vector<Contender> contenders{};  ///< the default first
  std::optional<std::size_t> winner{};  ///< the best other than the default; nothing if none lasts
  std::optional<HeldOut> held_out{};    ///< if there is a winner
  /// Better than the default on held-out seeds for sure: the interval of the paired differences is
  /// below 0, and the constraints are kept.
  bool is_better = false;
  [[nodiscard]] std::optional<MeanInterval> Difference() const;
};

/// All settings that a method tries at once; of bayes, those it begins with. Complains of a grid
/// that is too large.
[[nodiscard]] Expected<std::vector<SettingValues>> FirstSettings(const ParameterSpace& space,
                                                                 const TuningRules& rules);

/// Searches, and judges the best setting but the default (which may have been better) on held-out
/// seeds: `fly` is asked for seed indices 0 to runs-1 in the search, and runs to 2 runs-1 then.
/// Nothing if interrupted. REQUIRES: FirstSettings does not complain.
[[nodiscard]] std::optional<TuningOutcome> RunTuning(const ParameterSpace& space,
                                                     const SettingValues& by_default,
                                                     const TuningRules& rules,
                                                     const Race::Fly& fly);

}  // namespace limpet
