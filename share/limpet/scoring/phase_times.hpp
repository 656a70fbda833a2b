// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// How long the mission manager was in one phase.
struct PhaseTime {
  std::string phase;  ///< ALIGN, DIVE, SURVEY, SURFACE_FIX, RETURN, ASCEND, FIX, DONE
  double seconds = 0.0;
};

/// What SURVEY was interrupted for: up to the surface and there, for a fix (BHV_SurfaceFix). The
/// way down again is of the survey.
inline constexpr const char* kSurfaceFixPhase = "SURFACE_FIX";

/// Phases in the order in which they were first entered; one that was entered again counts once,
/// with its whole time. The wait for DEPLOY does not count; what comes after the mission's end is
/// DONE, so that of a session that begins with DEPLOY they add up to its duration. `end`: MOOS time
/// of the last pose.
[[nodiscard]] std::vector<PhaseTime> TimesOfPhases(const SessionRecord& record, Seconds end);

}  // namespace limpet
