// SPDX-License-Identifier: MIT
// Where a saved session looked from, and when its mission was in which phase.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/session/session_memory.hpp"

namespace limpet {

/// Fills in `views` of `prior`: the frames of dive, survey and return, thinned to one
/// per look. Looks with a box that is none of `landmarks`' are kept whole: there something was
/// seen that the session did not list.
void AddFormerViews(const SessionMemory& memory, const std::vector<int>& landmarks,
                    SessionPrior& prior);

/// One line per phase: `first_sight,phase`.
[[nodiscard]] std::string PhasesToCsv(const std::vector<PhaseStart>& phases);
/// The error names the line that is none.
[[nodiscard]] Expected<std::vector<PhaseStart>> PhasesFromCsv(std::string_view text);

}  // namespace limpet
