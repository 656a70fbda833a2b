// SPDX-License-Identifier: MIT
#include "behaviors/BHV_CoverArea.hpp"

#include "limpet/helm/registry.hpp"

namespace limpet {

void BHV_CoverArea::Shape(const Situation&, double weight, SearchGoals& goals) const {
  goals.objective.ground.cover += weight * params_.rates.cover;
  goals.objective.ground.frontier += weight * params_.rates.frontier;
}

std::optional<Bid> BHV_CoverArea::Value(const Prospect& prospect, const Situation& now) const {
  const GroundWorth worth = params_.rates.Of(prospect.seen, now.ground->swath());
  return Bid{
      .value = worth.useful - worth.ragged - prospect.length(),
      .why = {{"useful", worth.useful}, {"ragged", worth.ragged}, {"length", prospect.length()}},
      .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_CoverArea);

}  // namespace limpet
