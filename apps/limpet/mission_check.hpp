// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/registry.hpp"
#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {

/// Problems of a whole mission folder. `syntax`: what cannot be read or is not allowed (exit code
/// 2). `geometry`: what reads well and cannot work, e.g. an object outside the area (exit code 3).
struct MissionProblems {
  std::vector<ConfigProblem> syntax;
  std::vector<ConfigProblem> geometry;
};

/// Parses mission.moos, its behavior files, scenario.yaml and expect.yaml (if there are any) and
/// checks them against each other. Reports every problem, not the first.
[[nodiscard]] MissionProblems CheckMission(const std::filesystem::path& folder);

/// Every problem of the apps' blocks and of the behavior files.
[[nodiscard]] std::vector<ConfigProblem> CheckConfiguration(const MissionFile& mission,
                                                            const std::filesystem::path& folder);

/// Geometry alone: objects inside the area, the seabed below the survey altitude, room to turn.
[[nodiscard]] std::vector<ConfigProblem> CheckGeometry(const MissionFile& mission,
                                                       const std::optional<Scenario>& scenario,
                                                       const std::string& scenario_file);

/// Params of an app as its block sets them. Throws ConfigError.
template <class P>
[[nodiscard]] P ReadAppParams(const MissionFile& mission, const std::string& app) {
  const ConfigBlock* block = mission.Block(app);
  return block != nullptr ? ReadParams<P>(*block, CommonAppKeys()) : P{};
}

}  // namespace limpet
