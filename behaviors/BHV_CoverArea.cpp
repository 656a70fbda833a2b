// SPDX-License-Identifier: MIT
#include "behaviors/BHV_CoverArea.hpp"

#include "limpet/helm/registry.hpp"

namespace limpet {

void BHV_CoverArea::Shape(const Situation&, double weight, SearchObjective& objective) const {
  objective.w_cover = weight * params_.cover_weight;
  objective.w_frontier = weight * params_.frontier_weight;
}

std::optional<Bid> BHV_CoverArea::Value(const Prospect& prospect, const Situation& now) const {
  const double useful =
      params_.cover_weight * prospect.sight.new_area / now.ground->swath();
  const double ragged = params_.frontier_weight * prospect.sight.frontier_growth;
  return Bid{.value = useful - ragged - prospect.length(),
             .why = {{"useful", useful}, {"ragged", ragged}, {"length", prospect.length()}},
             .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_CoverArea);

}  // namespace limpet
