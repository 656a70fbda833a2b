// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {

/// Gives a mission what the case needs beside its fault.
void AddProp(MissionFile& mission, const TrialPlaces& places, const SafetyCase& tested,
             SafetyPhase phase);

/// What the case needs in the mission's scenario beside its fault, as lines for the end of the
/// scenario's file; empty: nothing.
[[nodiscard]] std::string PropLines(const Scenario& scenario, const SafetyCase& tested);

/// One more line of an app's block; those with its key stay. Throws ConfigError without the block.
void AddLine(MissionFile& mission, std::string_view app, ConfigEntry line);

/// What SURVEY_PHASE says in a phase.
[[nodiscard]] std::string WordOf(SafetyPhase phase);

}  // namespace limpet
