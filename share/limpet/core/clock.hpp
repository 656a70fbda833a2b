// SPDX-License-Identifier: MIT
// The only place that reads a clock: everything else is handed its time, so that warp, replay and
// virtual time work everywhere.
//
// Vehicle time is what all of a vehicle goes by. It is the date at which the community started plus
// what the machine's monotonic clock has counted since: somebody may set the wall clock meanwhile,
// and no vehicle turns or surfaces for it (docs/adr/0014).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// Seconds since 1970 by the wall clock, which may be set at any time: to be shown and recorded,
/// never to be reckoned with.
[[nodiscard]] Seconds UnixTime();
/// Seconds that never jump, from an arbitrary origin, the same for all processes of a machine.
[[nodiscard]] Seconds SteadyTime();
/// Seconds that the calling thread has had a processor.
[[nodiscard]] Seconds ThreadTime();

/// Vehicle time less the machine's monotonic clock [ns]. What processes share of it, they agree on.
struct ClockOrigin {
  std::int64_t ns = 0;
  bool operator==(const ClockOrigin&) const = default;
};
/// Origin of this process's clock: as its environment says (`kClockOriginVariable`: whoever started
/// the community puts it there), else the date when it is first asked for.
[[nodiscard]] ClockOrigin OwnClockOrigin();
inline constexpr const char* kClockOriginVariable = "LIMPET_CLOCK_ORIGIN";
/// The origin as text for an environment or the wire; reading it back gives nothing for what is
/// none.
[[nodiscard]] std::string TextOf(ClockOrigin origin);
[[nodiscard]] std::optional<ClockOrigin> ParseClockOrigin(std::string_view text);
/// Identity of the machine's present run; clocks that share it count alike. Empty if unknown.
[[nodiscard]] std::string BootId();

/// Seconds since 1970 as the vehicle counts them: never steps.
[[nodiscard]] Seconds VehicleTime();
/// Vehicle time times `warp`, as MOOS counts; warp is not negotiated, all parties of a community
/// are told the same.
[[nodiscard]] Seconds MoosTime(double warp);

}  // namespace limpet
