// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/helm/behavior.hpp"
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
};

/// How options of different length are compared.
enum class OptionOrder {
  kPerMetre,  ///< by the sum of bids per metre of option: what follows a short one counts too
  kBySum      ///< by the sum alone
};
struct DecisionRule {
  OptionOrder order = OptionOrder::kPerMetre;
  int listed = 5;  ///< options that go into the bids, at most
};

/// "Where next": every running behavior values every option; values times weights are added, vetoed
/// options dropped, the best taken; among equals the first offered. HELM_BIDS lists the best few
/// and says how many were valued.
[[nodiscard]] ViewDecision DecideView(std::span<const WeightedBehavior> behaviors,
                                      const Situation& now, std::vector<Option> options,
                                      SeenAlong& seen, const DecisionRule& rule = {});

}  // namespace limpet
