// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/helm/behavior.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/situation.hpp"

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
  std::vector<BehaviorFailure> failures;  ///< one per behavior: it has had no say, or not all of it
};

/// "Where next": every running behavior values every option; values times weights are added, vetoed
/// options dropped, the best taken; among equals the first offered. HELM_BIDS lists all of them. A
/// behavior that throws, or bids a number that is none, has no say at all.
[[nodiscard]] ViewDecision DecideView(std::span<const WeightedBehavior> behaviors,
                                      const Situation& now, std::vector<Option> options,
                                      SeenAlong& seen, OptionOrder order = OptionOrder::kPerMetre);

}  // namespace limpet
