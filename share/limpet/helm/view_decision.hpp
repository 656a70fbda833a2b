// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/helm/warning_book.hpp"

namespace limpet {

/// A running behavior with its weight (`pwt`).
struct WeightedBehavior {
  std::string name;
  double weight = 1.0;
  Behavior* behavior = nullptr;
};

/// What was chosen, and the bids that explain it (best options first).
struct ViewDecision {
  std::optional<Option> chosen;  ///< nothing if every option is vetoed or none was offered
  HelmBids bids;
  /// One per behavior: it has had no say, or not all of it.
  std::vector<BehaviorFailure> failures{};
  std::vector<OwnedWarning> late{};  ///< who has had no say for the time that it took, or rests
};

/// "Where next": every running behavior values every option; values times weights are added, vetoed
/// options dropped, the best taken; among equals the first offered. HELM_BIDS lists all of them. A
/// behavior that throws, bids a number that is none, or by `watch` takes too long over all its
/// bids, has no say at all.
[[nodiscard]] ViewDecision DecideView(std::span<const WeightedBehavior> behaviors,
                                      const Situation& now, std::vector<Option> options,
                                      SeenAlong& seen, OptionOrder order = OptionOrder::kPerMetre,
                                      AnswerWatch* watch = nullptr);

}  // namespace limpet
