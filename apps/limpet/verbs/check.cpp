// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/check.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/mission_check.hpp"

namespace limpet {
namespace {

nlohmann::ordered_json JsonOf(const std::vector<ConfigProblem>& problems) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ConfigProblem& problem : problems) {
    list.push_back({{"file", problem.where.file},
                    {"line", problem.where.line},
                    {"key", problem.key},
                    {"text", problem.text}});
  }
  return list;
}

}  // namespace

int RunCheck(std::span<const std::string> args) {
  const Arguments given(args, {}, {"json", "help"});
  if (given.Has("help")) {
    fmt::print(
        "usage: limpet check <mission folder> [--json]\n\nReports every problem of a mission with "
        "file and line, and runs nothing.\n");
    return kOk;
  }
  if (given.positionals().size() != 1) {
    throw UsageError("check takes one mission folder");
  }
  const MissionProblems problems = CheckMission(given.positionals()[0]);
  if (given.Has("json")) {
    const nlohmann::ordered_json out{{"syntax", JsonOf(problems.syntax)},
                                     {"geometry", JsonOf(problems.geometry)}};
    fmt::print("{}\n", out.dump(1));
  } else {
    for (const auto* list : {&problems.syntax, &problems.geometry}) {
      for (const ConfigProblem& problem : *list) {
        fmt::print("{}\n", problem.Format());
      }
    }
    const std::size_t count = problems.syntax.size() + problems.geometry.size();
    fmt::print("{}\n", count == 0 ? "no problems"
                                  : fmt::format("{} problem{}", count, count == 1 ? "" : "s"));
  }
  if (!problems.syntax.empty()) {
    return kUsage;
  }
  return problems.geometry.empty() ? kOk : kRefused;
}

}  // namespace limpet
