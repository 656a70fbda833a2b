// SPDX-License-Identifier: MIT
// What an ObjectStatuses makes of the water. docs/water.md.
#include <algorithm>
#include <cmath>

#include "estimation/change/object_statuses.hpp"

namespace limpet {
namespace {

/// Looks at one place share water, light and pose: each is worth this share of an independent one.
constexpr double kWorth = 0.5;
constexpr double kAsLikelyAsNot = 0.5;
/// What happens at one place changes the odds of two visibilities by a factor of e^5 at most.
constexpr double kMostOfOnePlace = 5.0;

/// What all images together say: sun, tilt and ground are not so well known as to be sure.
constexpr double kMostOfContrast = 6.0;

void TakeFrom(const PlaceWatch& watch, VisibilityBelief& water) {
  water.Add(watch.LogLikelihood(kWorth, kAsLikelyAsNot), kMostOfOnePlace);
}

}  // namespace

VisibilityBelief ObjectStatuses::Water() const {
  VisibilityBelief water(params_.detection.visibility, params_.visibility_spread);
  water.Add(contrasts_.LogLikelihood(), kMostOfContrast);
  for (const auto& [landmark, watch] : landmark_watch_) {
    TakeFrom(watch, water);
  }
  for (const std::optional<PlaceWatch>& watch : former_watch_) {
    if (watch) TakeFrom(*watch, water);
  }
  return water;
}

VisibilityBelief ObjectStatuses::FormerWater() {
  const StatusPriors& priors = params_.priors;
  const double stayed = priors.presence * priors.survival;
  const double came = (1.0 - priors.presence) * priors.appearance;
  const double was_there = stayed / (stayed + came);  // of what is here now
  VisibilityBelief water = former_views_.water;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const auto matched =
        std::ranges::find(match_.now_of_former, std::optional(static_cast<int>(i)));
    if (matched != match_.now_of_former.end()) continue;
    water.Add(FormerWatchAt(objects_[i]).LogLikelihood(kWorth, was_there), kMostOfOnePlace);
  }
  return water;
}

double ObjectStatuses::LambdaOf(const PlaceWatch& watch) const {
  return LambdaIn(water_, watch.evidence().Lambda(params_.priors.lookalike), params_.priors);
}

int ObjectStatuses::Looks(const PlaceWatch& watch) const {
  return static_cast<int>(std::lround(water_.Expect(watch.looks())));
}

}  // namespace limpet
