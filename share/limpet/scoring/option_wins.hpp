// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// How often the helm chose what one generator of options offered, and how far that was flown.
struct OptionWins {
  std::string source;   ///< generator: plan, beam, tour, home, ...
  int decisions = 0;    ///< won
  double path_m = 0.0;  ///< flown on its options, until the next decision or the ascent
};

/// Wins by way, longest first; of one length by name. Decisions without bids are not counted:
/// nobody can say whose option it was.
[[nodiscard]] std::vector<OptionWins> OptionWinsOf(const SessionRecord& record,
                                                   const PoseTrack& track);

}  // namespace limpet
