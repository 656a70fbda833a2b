// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ReduceObjectEntropy.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/view_entropy.hpp"

namespace limpet {

std::optional<Bid> BHV_ReduceObjectEntropy::Value(const Prospect& prospect,
                                                  const Situation& now) const {
  std::vector<OpiBelief> beliefs;
  std::ranges::transform(now.objects, std::back_inserter(beliefs), &WatchedObject::belief);
  const ObjectEntropy entropy = ObjectEntropyOf(ViewsOf(*prospect.option), *now.ground, beliefs);
  const double inherited = (1.0 - now.coverage.seabed) * entropy.inherited;
  return Bid{.value = lambda_ * (inherited + entropy.seen),
             .why = {{"seen", entropy.seen}, {"inherited", inherited}},
             .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_ReduceObjectEntropy);

}  // namespace limpet
