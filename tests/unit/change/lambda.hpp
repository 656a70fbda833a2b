// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/change/place_evidence.hpp"

namespace limpet::trial {

inline constexpr double kLookalike = 1e-4;

/// Lambda of a LookLog or PlaceWatch where one place in so many has a lookalike.
template <class Log>
double Lambda(const Log& log) {
  return log.evidence().Lambda(kLookalike)(0);
}

}  // namespace limpet::trial
