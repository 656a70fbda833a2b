// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/behavior_failure_warnings.hpp"
#include "limpet/helm/generator_registry.hpp"
#include "limpet/helm/option_generator.hpp"
#include "limpet/helm/view_decision.hpp"

namespace limpet {

/// Gathers what could be flown next: asks the running behaviors what they seek, and the mission's
/// generators, then the behaviors, for paths.
class OptionSearch {
 public:
  /// The generators of `names`, in that order. Throws ConfigError for one that is not known.
  /// With a `clock`, who takes too long is left out.
  OptionSearch(const GeneratorParams& params, std::string_view names, const Random& random,
               const RealClock& clock = {})
      : generators_(params.Build(names, random)), shapes_(clock), offers_(clock) {}

  /// Behaviors that throw are left out, and noted in `failures`; so are those that are late.
  [[nodiscard]] std::vector<Option> Gather(std::span<const WeightedBehavior> running,
                                           const Situation& now,
                                           std::vector<BehaviorFailure>& failures);
  /// The helm flies `option`.
  void TellChoice(const Option& option);
  /// Who was late since the last call.
  [[nodiscard]] std::vector<OwnedWarning> TakeLate() { return std::exchange(late_, {}); }

 private:
  /// What `running` seek together, but for those that throw or are late.
  [[nodiscard]] SearchGoals Goals(std::span<const WeightedBehavior> running, const Situation& now,
                                  std::vector<BehaviorFailure>& failures);
  /// True if the behavior has answered by `work`, in time by `watch`.
  template <class Work>
  bool Hears(const WeightedBehavior& behavior, AnswerWatch& watch,
             std::vector<BehaviorFailure>& failures, const Work& work) {
    bool is_heard = false;
    const auto late =
        watch.Ask(behavior.name, [&] { is_heard = Heard(behavior.name, failures, work); });
    if (late) late_.push_back(LatenessOf(behavior.name, *late));
    return is_heard && !late;
  }

  std::vector<std::unique_ptr<OptionGenerator>> generators_;
  AnswerWatch shapes_, offers_;  ///< over what behaviors seek, and over what they offer
  std::vector<OwnedWarning> late_;
};

}  // namespace limpet
