// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/change/log_space.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// What one session's looks at a place say of it, for each visibility that the water may have. Both
/// are ln P(seen | so) / P(seen | bare seabed), zero before any look.
struct PlaceEvidence {
  PerVisibility present;    ///< an object is there
  PerVisibility lookalike;  ///< something is there that looks like one, and stays

  /// ln P(seen | an object) / P(seen | none), where nothing is a lookalike with that chance.
  [[nodiscard]] PerVisibility Lambda(double lookalike_chance) const {
    return present - Absent(lookalike_chance);
  }
  /// ln P(seen | no object) / P(seen | bare seabed).
  [[nodiscard]] PerVisibility Absent(double lookalike_chance) const {
    return LogSum(PerVisibility(std::log1p(-lookalike_chance)),
                  PerVisibility(std::log(lookalike_chance) + lookalike));
  }
};

}  // namespace limpet
