// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// How long the mission manager was in one phase.
struct PhaseTime {
  std::string phase;  ///< ALIGN, DIVE, SURVEY, RETURN, ASCEND, FIX
  double seconds = 0.0;
};

/// Phases in the order in which they were first entered; one that was entered again counts once,
/// with its whole time. Before the first and after the mission's end nothing counts. `end`: MOOS
/// time of the last pose, where a session that was cut short ends.
[[nodiscard]] std::vector<PhaseTime> TimesOfPhases(const SessionRecord& record, Seconds end);

}  // namespace limpet
