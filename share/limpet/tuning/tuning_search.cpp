// SPDX-License-Identifier: MIT
#include "limpet/tuning/tuning_search.hpp"

#include <algorithm>

#include "limpet/core/random.hpp"
#include "limpet/tuning/bayes_search.hpp"

namespace limpet {
namespace {

/// Settings that are tried between two fits of the model: enough for a few cores, and the same for
/// every number of them.
constexpr int kBatch = 4;

int FirstOfBayes(const ParameterSpace& space, int settings) {
  const int dimensions = static_cast<int>(space.parameters().size());
  return std::min(settings, 2 * dimensions + 2);
}

/// False if interrupted.
bool SearchByModel(const ParameterSpace& space, const TuningRules& rules, Race& race) {
  for (int tried = FirstOfBayes(space, rules.settings); tried < rules.settings;) {
    const std::vector<SettingValues> next =
        MostPromising(space, race.contenders(), std::min(kBatch, rules.settings - tried),
                      MixSeed(rules.seed, "round " + std::to_string(tried)));
    if (next.empty()) break;
    tried += static_cast<int>(next.size());
    race.Enter(next);
    if (!race.Run()) return false;
  }
  return true;
}

bool KeepsConstraints(const Contender& contender, double share) {
  const auto runs = static_cast<double>(contender.outcomes.size());
  return runs - static_cast<double>(contender.Failures()) >= share * runs;
}

std::optional<HeldOut> FlyHeldOut(const Contender& by_default, const Contender& winner,
                                  std::size_t runs, const Race::Fly& fly) {
  HeldOut held{.by_default = {.setting = by_default.setting, .is_default = true},
               .winner = {.setting = winner.setting}};
  std::vector<Flight> flights;
  for (std::size_t seed = runs; seed < 2 * runs; ++seed) {
    flights.push_back({.contender = 0, .seed_index = seed});
    flights.push_back({.contender = 1, .seed_index = seed});
  }
  const std::vector<RunOutcome> outcomes = fly({held.by_default, held.winner}, flights);
  if (outcomes.size() != flights.size()) return std::nullopt;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    (i % 2 == 0 ? held.by_default : held.winner).outcomes.push_back(outcomes[i]);
  held.differences = PairedDifferences(held.winner, held.by_default);
  return held;
}

}  // namespace

std::optional<MeanInterval> TuningOutcome::Difference() const {
  if (!held_out || held_out->differences.empty()) return std::nullopt;
  return IntervalOf(held_out->differences);
}

Expected<std::vector<SettingValues>> FirstSettings(const ParameterSpace& space,
                                                   const TuningRules& rules) {
  if (rules.method == "grid") return space.Grid();
  const int count = rules.method == "bayes" ? FirstOfBayes(space, rules.settings) : rules.settings;
  return space.Spread(count, rules.seed);
}

std::optional<TuningOutcome> RunTuning(const ParameterSpace& space, const SettingValues& by_default,
                                       const TuningRules& rules, const Race::Fly& fly) {
  Race race({.runs = rules.runs, .share = rules.share}, {.setting = by_default}, fly);
  std::vector<SettingValues> first = *FirstSettings(space, rules);
  std::erase(first, by_default);
  race.Enter(first);
  if (!race.Run()) return std::nullopt;
  if (rules.method == "bayes" && !SearchByModel(space, rules, race)) return std::nullopt;
  TuningOutcome outcome{.contenders = race.contenders(), .winner = race.Best(false)};
  if (!outcome.winner) return outcome;
  outcome.held_out =
      FlyHeldOut(outcome.contenders.front(), outcome.contenders[*outcome.winner], rules.runs, fly);
  if (!outcome.held_out) return std::nullopt;
  const std::optional<MeanInterval> difference = outcome.Difference();
  outcome.is_better = difference && difference->high && *difference->high < 0.0 &&
                      KeepsConstraints(outcome.held_out->winner, rules.share);
  return outcome;
}

}  // namespace limpet
