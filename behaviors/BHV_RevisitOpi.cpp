// SPDX-License-Identifier: MIT
#include "behaviors/BHV_RevisitOpi.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/helm/registry.hpp"

namespace limpet {

void BHV_RevisitOpi::Shape(const Situation& now, double weight, SearchGoals& goals) const {
  std::ranges::move(policy_.OpenTargets(now, weight), std::back_inserter(goals.objective.targets));
  goals.objective.target_decay_m = decay_.value();
}

std::optional<Bid> BHV_RevisitOpi::Value(const Prospect& prospect, const Situation& now) const {
  Objective targets;
  targets.target_decay_m = decay_.value();
  targets.targets = policy_.OpenTargets(now, 1.0);
  if (targets.targets.empty()) {
    return std::nullopt;
  }
  const double worth = TargetValueOf(prospect.whole(), targets);
  Bid bid{.value = worth,
          .why = {{"looks_worth", worth},
                  {"open_objects", static_cast<double>(targets.targets.size())}},
          .veto = {}};
  int fruitless = 0;
  for (const WatchedObject& object : now.objects) {
    fruitless += object.fruitless;
  }
  if (fruitless > 0) {
    bid.why.push_back({"fruitless_looks", static_cast<double>(fruitless)});
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_RevisitOpi);

}  // namespace limpet
