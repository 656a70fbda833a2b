// SPDX-License-Identifier: MIT
// The only place that reads a clock: everything else is handed its time, so that warp, replay and
// virtual time work everywhere.
#pragma once

#include "limpet/core/units.hpp"

namespace limpet {

/// Seconds since 1970.
[[nodiscard]] Seconds UnixTime();
/// Seconds that never jump, from an arbitrary origin.
[[nodiscard]] Seconds SteadyTime();
/// Seconds that the calling thread has had a processor.
[[nodiscard]] Seconds ThreadTime();
/// Seconds since 1970 times `warp`, as MOOS counts; warp is not negotiated, all parties of a
/// community are told the same.
[[nodiscard]] Seconds MoosTime(double warp);

}  // namespace limpet
