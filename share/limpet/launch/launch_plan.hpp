// SPDX-License-Identifier: MIT
// What is to be launched, and how: from the ANTLER block and the command line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

enum class RestartPolicy { kNever, kOnFailure, kAlways };

struct LaunchItem {
  std::string name;  ///< MOOS name
  std::filesystem::path program;
  std::vector<std::string> args;
  /// Where it runs; empty: where the launcher does. Programs that are not ours look for the files
  /// that they are told beside the mission.
  std::filesystem::path working_folder{};
  RestartPolicy restart = RestartPolicy::kOnFailure;
  bool is_database = false;
  /// Without a sign of life for this long (real time) it hangs, and is killed; 0: never.
  Seconds hung_after = kHungAfter;
  bool is_vital = false;  ///< without it the vehicle cannot come home: given up, the mission ends
  /// Three of the periods at which our apps say how they are (<APP>_STATUS).
  static constexpr Seconds kHungAfter{6.0};
};

/// `pLaunch file.moos ["A B C"] [--Name=value ...] [options]`
struct LaunchCommand {
  std::filesystem::path mission_file;
  std::vector<std::string> only;  ///< MOOS names to launch; empty: all
  std::vector<std::pair<std::string, std::string>> replacements;  ///< lines of the mission file
  std::filesystem::path run_folder;    ///< empty: the next one that is free (run_folders.hpp)
  std::filesystem::path prior_folder;  ///< former session; empty: the latest dive's
  std::string session = "discovery";
  std::string seed = "1";
  std::string until;  ///< variable whose first news ends the run; empty: none
  bool deploys = false;
  bool allows_outside = false;  ///< the mission may start any program and write anywhere
  bool is_quiet = false;
  bool wants_help = false;
};

/// A process of the mission whose program is not on this machine.
struct MissingProgram {
  std::string name;  ///< MOOS name
  std::string binary;
  bool is_vital = true;       ///< no viewer or tool
  std::string passed_over{};  ///< a folder of the mission that is searched with --allow-outside
  SourceLine where;
};

struct LaunchPlan {
  MissionFile mission;
  std::filesystem::path mission_file;  ///< what the processes read: with replacements, a copy
  std::vector<LaunchItem> items;
  std::vector<MissingProgram> missing;  ///< the rest is launched without them
  std::vector<ConfigProblem> notes;     ///< what a reader of the mission should know
  Seconds between;                      ///< pause between starts (real time)
  double warp = 1.0;
};

/// Throws ConfigError for a bad command line.
[[nodiscard]] LaunchCommand ReadLaunchCommand(const std::vector<std::string>& args);
[[nodiscard]] std::string LaunchHelp(const std::string& caller);

/// Every line of `text` that sets one of the names (case as written, in any block) gets the value
/// given instead.
[[nodiscard]] std::string WithReplacements(
    std::string_view text, const std::vector<std::pair<std::string, std::string>>& replacements);

/// Reads the mission, writes its copy `<file>++` if lines of it or of its plugs are replaced, and
/// finds the programs: in `own_folder`, then on PATH. What is not there goes to `missing`. Throws
/// ConfigError with every problem: no program at all or no database, one that a mission may not
/// start, a log outside, ...
[[nodiscard]] LaunchPlan PlanLaunch(const LaunchCommand& command,
                                    const std::filesystem::path& own_folder);

}  // namespace limpet
