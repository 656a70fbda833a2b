// SPDX-License-Identifier: MIT
#include "limpet/helm/option_search.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace limpet {

SearchGoals GoalsOf(std::span<const WeightedBehavior> running, const Situation& now,
                    std::vector<BehaviorFailure>& failures) {
  SearchGoals goals;
  for (const WeightedBehavior& behavior : running) {
    SearchGoals shaped = goals;
    const bool is_heard = Heard(behavior.name, failures,
                                [&] { behavior.behavior->Shape(now, behavior.weight, shaped); });
    if (is_heard) {
      goals = std::move(shaped);
    }
  }
  return goals;
}

std::vector<Option> OptionSearch::Gather(std::span<const WeightedBehavior> running,
                                         const Situation& now,
                                         std::vector<BehaviorFailure>& failures) {
  const SearchGoals goals = GoalsOf(running, now, failures);
  std::vector<Option> options;
  for (const auto& generator : generators_) {
    generator->Offer(now, goals, options);
  }
  for (const WeightedBehavior& behavior : running) {
    std::vector<Option> offered = options;
    if (Heard(behavior.name, failures, [&] { behavior.behavior->Offer(now, offered); })) {
      std::move(
          offered.begin() + static_cast<std::ptrdiff_t>(std::min(options.size(), offered.size())),
          offered.end(), std::back_inserter(options));
    }
  }
  for (const auto& generator : generators_) {
    generator->Complete(options);
  }
  return options;
}

void OptionSearch::TellChoice(const Option& option) {
  for (const auto& generator : generators_) {
    generator->OnChoice(option);
  }
}

}  // namespace limpet
