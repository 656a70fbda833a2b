// SPDX-License-Identifier: MIT
// A mission flown in simulation before it is flown at sea: whether a safety rule trips, whether the
// energy reaches, whether it comes home.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limpet/mission/mission_file.hpp"
#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {

/// A rule that tripped, where and when; again where it asks for more.
struct TrippedRule {
  std::string rule;
  std::string action;  ///< that it asked for
  std::string phase;
  double after_s = 0.0;                              ///< since the session's start
  double north_m = 0.0, east_m = 0.0, down_m = 0.0;  ///< where the vehicle truly was
  [[nodiscard]] bool IsWarning() const;
};

/// The battery of a flight, truly, but for the reserve that the vehicle reckons [Wh].
struct FlightEnergy {
  double used_wh = 0.0, left_wh = 0.0, reserve_wh = 0.0;
  bool is_off = false;
};

/// What came of a flight.
struct DryFlight {
  std::string session = "discovery";
  std::string ended;  ///< home, aborted, timeout, lost
  double duration_s = 0.0;
  double way_m = 0.0;                  ///< true
  double home_error_m = 0.0;           ///< from the start, horizontally
  double down_m = 0.0;                 ///< at the end
  std::optional<FlightEnergy> energy;  ///< of a vehicle with a battery
  std::vector<TrippedRule> tripped;    ///< in order, each once for each action
  /// Why such a mission must not be launched, in words; empty: it may be. Rules count that end or
  /// bend the mission.
  [[nodiscard]] std::vector<std::string> Objections() const;
  /// What the rules only warn of, in words.
  [[nodiscard]] std::vector<std::string> Remarks() const;
};

/// A mission that is flown as it is, but with boxes for a camera and without a log.
[[nodiscard]] MissionFile PreparedForDryRun(MissionFile mission);

/// The sessions of a mission in their order: a discovery and, where it keeps what it found and its
/// scenario says what is there then, a change session that is compared with it.
[[nodiscard]] std::vector<std::string> DrySessions(const MissionFile& mission,
                                                   const TrialPlaces& places);

/// `mission` as prepared; one of its sessions, after those before it were flown with this seed.
/// Throws ConfigError if it cannot be flown.
[[nodiscard]] DryFlight FlyDry(const MissionFile& mission, const TrialPlaces& places,
                               std::uint64_t seed, const std::string& session = "discovery");

}  // namespace limpet
