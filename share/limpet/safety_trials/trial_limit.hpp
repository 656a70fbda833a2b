// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "limpet/runs/session_runner.hpp"
#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {

/// The limit of the case's rule that a trial in `phase` sets, in the rule's unit; absent: it stays
/// as the mission has it. May fly `calm`, the mission without a fault.
[[nodiscard]] std::optional<double> LimitFor(const SafetyCase& tested, SafetyPhase phase,
                                             const MissionFile& calm, const TrialPlaces& places,
                                             std::uint64_t seed);

/// A discovery, with its files in the scratch folder.
[[nodiscard]] SessionPlan TrialPlan(const TrialPlaces& places, std::uint64_t seed);

}  // namespace limpet
