// SPDX-License-Identifier: MIT
// A look at a mission before anything of it is started. It knows the apps and behaviors that are
// linked into the program (AppRegistry, BehaviorRegistry); all others are somebody else's.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// Energy that a survey is expected to take, by its lanes and the vehicle's sheets [Wh].
struct EnergyOutlook {
  double needed_wh = 0.0;  ///< from the start to home
  /// Part of `needed_wh` for the way home from the farthest place and the wait at the surface
  /// there.
  double home_wh = 0.0;
  double charged_wh = 0.0;  ///< held by the battery at the start
  double reserve_wh = 0.0;  ///< to be left at home
};

/// What is to be said of a mission. `syntax`: what cannot be read or is not allowed (exit code 2).
/// `geometry`: what reads well and cannot work, e.g. water deeper than the helm's domain (exit code
/// 3). `notes`: what may be meant so: what belongs to other people's apps, what is near a limit.
/// `refused_here`: those of the notes for which Limpet's own programs would not start what is
/// written for stock ones: its helm in pHelmIvP's place, its pShare, its launcher.
/// `energy`: what the mission is expected to take, if its vehicle has a battery.
struct MissionProblems {
  std::vector<ConfigProblem> syntax;
  std::vector<ConfigProblem> geometry;
  std::vector<ConfigProblem> notes;
  std::vector<ConfigProblem> refused_here{};
  std::optional<EnergyOutlook> energy{};
};

/// What is set in a mission before it is looked at. May throw ConfigError, which is then found.
using MissionChange = std::function<void(MissionFile&)>;

/// The mission file, the behavior files, scenario.yaml and expect.yaml beside it. Every problem,
/// not the first; geometry only where the syntax is right. Never throws for what a file says.
[[nodiscard]] MissionProblems CheckMissionFile(const std::filesystem::path& file,
                                               const MissionChange& change = {});

/// A mission that is read already, and perhaps changed since; `folder` is where its files are.
[[nodiscard]] MissionProblems CheckLoadedMission(const MissionFile& mission,
                                                 const std::filesystem::path& folder);

/// A behavior file alone. Behaviors that are not Limpet's are notes.
[[nodiscard]] MissionProblems CheckBehaviorFile(const std::filesystem::path& file);

/// A mission folder (its mission.moos, or every .moos if there is none), a .moos or a .bhv file.
[[nodiscard]] MissionProblems CheckPath(const std::filesystem::path& path);

}  // namespace limpet
