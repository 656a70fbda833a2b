// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ReduceMapEntropy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/view_entropy.hpp"

namespace limpet {

void BHV_ReduceMapEntropy::Shape(const Situation&, double weight, SearchGoals& goals) const {
  goals.objective.ground.cover += weight;  // no entropy, but new ground is what it is about
}

std::optional<Bid> BHV_ReduceMapEntropy::Value(const Prospect& prospect,
                                               const Situation& now) const {
  const double nats = MapEntropyOf(ViewsOf(*prospect.option), *now.ground, params_.counts_band);
  return Bid{.value = std::log(std::max(nats, std::numeric_limits<double>::min())),
             .why = {{"map_entropy", nats}},
             .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_ReduceMapEntropy);

}  // namespace limpet
