// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "limpet/console/frame.hpp"
#include "limpet/explain/explanation.hpp"
#include "limpet/explain/motion_explanation.hpp"

namespace limpet {

/// The decision for a terminal: a line per option with what each behavior added to it, the reasons
/// of those who bid on the one that was chosen, and what would have changed the choice.
[[nodiscard]] Frame FrameOf(const Explanation& explanation);
/// A line per decision: when, why then, what was chosen, and whose bid decided; and one for each of
/// `stops`. Both in order of time.
[[nodiscard]] Frame ChangesOf(std::span<const LoggedDecision> decisions,
                              std::span<const MotionChange> stops = {});

/// How a vehicle moves that no behavior leads, as ExplainMotion has it.
[[nodiscard]] Frame FrameOfMotion(const Explanation& explanation);
/// A line each: when, why then, what it does, and who wants what.
[[nodiscard]] Frame FrameOfMotions(std::span<const MotionChange> changes);

}  // namespace limpet
