// SPDX-License-Identifier: MIT
#include "behaviors/BHV_CoverArea.hpp"

#include "limpet/helm/registry.hpp"
#include "limpet/planning/current_toll.hpp"

namespace limpet {
namespace {

/// Metres of path before ground is first seen, mean over the area, beyond what they are on the best
/// of ways, which shows a swath's width all the time.
double Lateness(const NewlySeen& seen, const Ground& ground) {
  const double least = 0.5 * seen.new_area * seen.new_area / ground.swath();
  return (seen.delay - least) / ground.wanted_m2();
}

}  // namespace

void BHV_CoverArea::Shape(const Situation&, double weight, SearchGoals& goals) const {
  goals.objective.ground.cover += weight * params_.rates.cover;
  goals.objective.ground.frontier += weight * params_.rates.frontier;
  goals.objective.ground.early += weight * params_.rates.early;
  goals.objective.ground.most += weight * params_.rates.most;
}

std::optional<Bid> BHV_CoverArea::Value(const Prospect& prospect, const Situation& now) const {
  const GroundWorth worth = params_.rates.Of(prospect.seen, now.ground->swath());
  const double length = prospect.whole().length();
  Bid bid{.value = worth.useful - worth.ragged - length,
          .why = {{"useful", worth.useful}, {"ragged", worth.ragged}, {"length", length}},
          .veto = {}};
  if (!now.course_cost.metres.empty()) {
    const double toll = CurrentToll(now.course_cost, prospect.whole());
    bid.value -= toll;
    bid.why.push_back({"current", toll});
  }
  // Only wholes show the same ground: of others the one that shows less would be the less late.
  if (prospect.option->is_whole()) {
    const double late = params_.rates.early * Lateness(prospect.seen, *now.ground);
    const double lacking = params_.rates.cover * prospect.option->lacking_m;
    const double most = params_.rates.most * prospect.option->most_m;
    bid.value -= late + most + lacking;
    bid.why.push_back({"late", late});
    bid.why.push_back({"most", most});
    bid.why.push_back({"lacking", lacking});
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_CoverArea);

}  // namespace limpet
