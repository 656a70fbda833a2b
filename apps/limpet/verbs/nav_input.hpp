// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/limpet/cli.hpp"
#include "estimation/replay/replay.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/recordings/recording.hpp"

namespace limpet {

/// What `limpet nav` replays.
struct NavInput {
  SensorStream stream;
  bool is_own_navigation = false;      ///< made of what a vehicle's own navigation said
  std::vector<TimedPlace> own_places;  ///< ... and where it took itself to be
};

/// Input from a recording of any kind. Throws Refusal that says what lacks where no track can be
/// reckoned.
[[nodiscard]] Expected<NavInput> LoadNavInput(const Arguments& given);

/// How far the track lies from the vehicle's own, for the summary; empty without such.
[[nodiscard]] std::string OwnTrackSummary(const NavInput& input, const ReplayResult& result);

/// `limpet nav --check`: prints what a recording holds and what of it agrees. The exit code.
[[nodiscard]] int CheckRecording(const Arguments& given);

}  // namespace limpet
