// SPDX-License-Identifier: MIT
// The command line that every process of a community takes, as MOOS users type it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// `<process> [mission.moos] [name] [--moos_host=...] ...`
struct AppCommand {
  std::string process;
  std::string name;                    ///< MOOS name; the process's unless given
  std::filesystem::path mission_file;  ///< empty: defaults alone
  MissionFile mission;
  std::string host = "localhost";
  std::uint16_t port = 9000;
  std::string community = "limpet";  ///< only a database needs it
  double warp = 1.0;
  std::vector<ConfigEntry> overrides;  ///< AppTick and the like, from `--moos_app_tick=`
  std::vector<ConfigEntry> additions;  ///< lines behind the block's own, from the app's switches
  std::filesystem::path run_folder;  ///< `--run_folder=` or LIMPET_RUN_FOLDER; else the present one
  std::filesystem::path prior_folder;  ///< `--prior_folder=` or LIMPET_PRIOR_FOLDER
  std::string session = "discovery";   ///< `--session=` or LIMPET_SESSION
  std::uint64_t seed = 1;              ///< `--seed=` or LIMPET_SEED
  bool is_restarted = false;           ///< LIMPET_RESTARTED, set by the launcher
  bool allows_outside = false;         ///< `--allow_outside` or LIMPET_ALLOW_OUTSIDE
  bool wants_help = false, wants_example = false;
};

/// Reads the command line and the mission file it names. What the command line says wins over the
/// file's globals (ServerHost, ServerPort, Community, MOOSTimeWarp). Throws ConfigError.
[[nodiscard]] AppCommand ReadAppCommand(const std::string& process,
                                        std::span<const char* const> args);

/// One line for each switch.
[[nodiscard]] std::string AppCommandHelp(const std::string& process);

}  // namespace limpet
