// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "estimation/replay/replay.hpp"

namespace limpet {

/// What came of a replay, in a few lines for a person: what was refused, what the estimate itself
/// says that it does not know, what became of a former session's objects and of further sensors.
/// `doubtful`: from where on a place is in doubt, 1-sigma of an axis [m].
[[nodiscard]] std::string ReplaySummary(const SensorStream& stream, const ReplayResult& result,
                                        const FormerSession& former, double doubtful);

}  // namespace limpet
