// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// One session of a mission, run embedded.
struct SessionPlan {
  std::string session;  ///< discovery, change, ...
  std::filesystem::path mission_folder;
  std::filesystem::path run_folder;    ///< created if missing
  std::filesystem::path prior_folder;  ///< run folder of the session to compare with; empty if none
  std::uint64_t seed = 1;
  /// Virtual time after which the session is cut; without it, what its mission may take at most.
  std::optional<Seconds> longest{};
  bool delivers_truth_on_board =
      true;  ///< false withholds SIM_* from every app that is not a simulator
};

struct SessionOutcome {
  std::string ended;  ///< home, aborted, timeout or lost
  Seconds duration;   ///< virtual
  double wall_s = 0.0;
  /// Set if the session did not end by itself: why, and where the vehicle was then.
  std::optional<std::string> cut{};
};

/// The longest a mission may take by its own parameters (pSurvey's), with a margin; without a
/// mission manager nothing ends it, and three hours have to do.
[[nodiscard]] Seconds LongestSession(const MissionFile& mission);

using MessageObserver = std::function<void(const Message&)>;

/// Runs a session to its end. Throws ConfigError before anything is written if the mission does not
/// build.
[[nodiscard]] SessionOutcome RunSession(const MissionFile& mission, const SessionPlan& plan,
                                        const MessageObserver& observer);

/// Applies `app.key=value`, `behavior_name.key=value` or `global=value` to a mission; another
/// VehicleFile reaches every block. Throws ConfigError.
void ApplySetting(MissionFile& mission, const std::string& setting);

/// Processes of the ANTLER block that an embedded run hosts: all but the database and what needs a
/// network or a console.
[[nodiscard]] std::vector<std::string> EmbeddedApps(const MissionFile& mission);

}  // namespace limpet
