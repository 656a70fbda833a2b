// SPDX-License-Identifier: MIT
#include "behaviors/BHV_CoverArea.hpp"

#include "limpet/helm/registry.hpp"

namespace limpet {

void BHV_CoverArea::Shape(const Situation&, double weight, SearchGoals& goals) const {
  goals.objective.ground.cover += weight * params_.rates.cover;
  goals.objective.ground.frontier += weight * params_.rates.frontier;
  goals.objective.ground.early += weight * params_.rates.early;
}

std::optional<Bid> BHV_CoverArea::Value(const Prospect& prospect, const Situation& now) const {
  const GroundWorth worth = params_.rates.Of(prospect.seen, now.ground->swath());
  const double length = prospect.whole().length();
  Bid bid{.value = worth.useful - worth.ragged - length,
          .why = {{"useful", worth.useful}, {"ragged", worth.ragged}, {"length", length}},
          .veto = {}};
  // Only wholes show the same ground: of others the one that shows less would be the less late.
  if (prospect.option->is_whole()) {
    const double late = params_.rates.early * prospect.seen.delay / now.ground->wanted_m2();
    bid.value -= late;
    bid.why.push_back({"late", late});
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_CoverArea);

}  // namespace limpet
