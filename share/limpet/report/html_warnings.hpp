// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/scoring/warning_record.hpp"

namespace limpet {

/// The warnings of a session as a table of the report's page, the gravest first: how often each was
/// raised, when first, for how long it stood, when it was over, what it said last, and from its
/// declaration what it means and what to do. Times are seconds after `begun`; `end` closes what
/// still stood. Both are MOOS times.
[[nodiscard]] std::string WarningsTable(const std::vector<WarningRecord>& warnings, Seconds begun,
                                        Seconds end);

}  // namespace limpet
