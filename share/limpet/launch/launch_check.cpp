// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_check.hpp"

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/preflight/preflight.hpp"

namespace limpet {

int RefuseToLaunch(const std::filesystem::path& mission_file) {
  constexpr int kUnreadable = 2, kCannotWork = 3;
  const MissionProblems found = CheckMissionFile(mission_file);
  for (const auto* list : {&found.syntax, &found.geometry}) {
    for (const ConfigProblem& problem : *list) {
      fmt::print(stderr, "{}\n", OneLine(problem.Format()));
    }
  }
  if (found.syntax.empty() && found.geometry.empty()) return 0;
  fmt::print(stderr, "pLaunch: nothing was started; `limpet check {}` says more\n",
             OneLine(mission_file.string()));
  return found.syntax.empty() ? kCannotWork : kUnreadable;
}

}  // namespace limpet
