// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limpet/app/registry.hpp"
#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/preflight/preflight.hpp"

namespace limpet {

/// What of a mission cannot be read, or cannot be run in one process: every problem.
[[nodiscard]] std::vector<ConfigProblem> CheckConfiguration(const MissionFile& mission,
                                                            const std::filesystem::path& folder);

/// What of a mission reads well and cannot work; nothing if its configuration is wrong.
[[nodiscard]] std::vector<ConfigProblem> CheckGeometry(const MissionFile& mission,
                                                       const std::filesystem::path& folder);

/// Params of an app as its block sets them. Throws ConfigError, also for what the mission must say
/// and does not.
template <class P>
[[nodiscard]] P ReadAppParams(const MissionFile& mission, const std::string& app) {
  const ConfigBlock* block = mission.Block(app);
  const ConfigBlock nothing{.name = app, .where = {.file = mission.file, .line = 0}, .entries = {}};
  return ReadParams<P>(block != nullptr ? *block : nothing, CommonAppKeys());
}

}  // namespace limpet
