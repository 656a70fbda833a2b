// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/change/place_watch.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// What was seen, and what was missed, of a place where an object is with this `chance` says of the
/// water. docs/water.md.
inline void LearnWater(const PlaceWatch& watch, double chance, VisibilityBelief& water) {
  // Looks at one place share water, light and pose: each is worth this share of an independent one.
  constexpr double kWorth = 0.5;
  // What happens at one place changes the odds of two visibilities by a factor of e^5 at most.
  constexpr double kMostOfOnePlace = 5.0;
  water.Add(watch.LogLikelihood({.chance = chance, .look_worth = kWorth}), kMostOfOnePlace);
}

}  // namespace limpet
