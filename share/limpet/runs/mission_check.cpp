// SPDX-License-Identifier: MIT
#include "limpet/runs/mission_check.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/mission/stand_ins.hpp"
#include "limpet/runs/session_runner.hpp"

namespace limpet {

std::vector<ConfigProblem> CheckConfiguration(const MissionFile& mission,
                                              const std::filesystem::path& folder) {
  std::vector<ConfigProblem> problems = CheckLoadedMission(mission, folder).syntax;
  std::vector<std::string> known;
  std::ranges::transform(AppRegistry(), std::back_inserter(known),
                         [](const auto& registered) { return registered.first; });
  for (const std::string& name : EmbeddedApps(mission)) {
    if (!AppRegistry().contains(OwnNameOf(name))) {
      problems.push_back({{.file = mission.file, .line = 0},
                          "Run",
                          fmt::format("no app `{}` to run embedded; nearest known: `{}`", name,
                                      NearestWord(name, known))});
    }
  }
  return problems;
}

std::vector<ConfigProblem> CheckGeometry(const MissionFile& mission,
                                         const std::filesystem::path& folder) {
  return CheckLoadedMission(mission, folder).geometry;
}

}  // namespace limpet
