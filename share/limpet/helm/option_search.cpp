// SPDX-License-Identifier: MIT
#include "limpet/helm/option_search.hpp"

namespace limpet {

SearchGoals GoalsOf(std::span<const WeightedBehavior> running, const Situation& now) {
  SearchGoals goals;
  for (const WeightedBehavior& behavior : running) {
    behavior.behavior->Shape(now, behavior.weight, goals);
  }
  return goals;
}

std::vector<Option> OptionSearch::Gather(std::span<const WeightedBehavior> running,
                                         const Situation& now) {
  const SearchGoals goals = GoalsOf(running, now);
  std::vector<Option> options;
  for (const auto& generator : generators_) {
    generator->Offer(now, goals, options);
  }
  for (const WeightedBehavior& behavior : running) {
    behavior.behavior->Offer(now, options);
  }
  return options;
}

void OptionSearch::TellChoice(const Option& option) {
  for (const auto& generator : generators_) {
    generator->OnChoice(option);
  }
}

}  // namespace limpet
