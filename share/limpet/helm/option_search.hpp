// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/helm/behavior_failure.hpp"
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

  /// Behaviors that throw are left out, and noted in `failures`.
  [[nodiscard]] std::vector<Option> Gather(std::span<const WeightedBehavior> running,
                                           const Situation& now,
                                           std::vector<BehaviorFailure>& failures);
  /// The helm flies `option`.
  void TellChoice(const Option& option);

 private:
  std::vector<std::unique_ptr<OptionGenerator>> generators_;
};

/// What `running` seek together, but for those that throw: they are noted in `failures`.
[[nodiscard]] SearchGoals GoalsOf(std::span<const WeightedBehavior> running, const Situation& now,
                                  std::vector<BehaviorFailure>& failures);

}  // namespace limpet
