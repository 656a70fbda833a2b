// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/helm/generator_registry.hpp"
#include "limpet/helm/option_generator.hpp"
#include "limpet/helm/view_decision.hpp"

namespace limpet {

/// Gathers what could be flown next: asks the running behaviors what they seek, and the mission's
/// generators, then the behaviors, for paths.
class OptionSearch {
 public:
  /// The generators of `names`, in that order. Throws ConfigError for one that is not known.
  OptionSearch(const GeneratorParams& params, std::string_view names, const Random& random)
      : generators_(params.Build(names, random)) {}

  [[nodiscard]] std::vector<Option> Gather(std::span<const WeightedBehavior> running,
                                           const Situation& now);
  /// The helm flies `option`.
  void TellChoice(const Option& option);

 private:
  std::vector<std::unique_ptr<OptionGenerator>> generators_;
};

/// What `running` seek together.
[[nodiscard]] SearchGoals GoalsOf(std::span<const WeightedBehavior> running, const Situation& now);

}  // namespace limpet
