// SPDX-License-Identifier: MIT
#include "tests/soak/soak_plan.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/mission/fault_kinds.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {
namespace {

/// Those that say which app are none: a soak hits processes itself.
std::vector<ConfigProblem> ProblemsOf(const SoakPlan& plan, const ConfigBlock& block) {
  std::vector<std::string> known;
  for (const FaultKind& kind : FaultKinds()) {
    if (!kind.is_about_app) known.emplace_back(kind.what);
  }
  std::vector<ConfigProblem> problems;
  for (const std::string& what : plan.fault) {
    if (std::ranges::find(known, what) == known.end()) {
      problems.push_back({block.where, "soak fault",
                          fmt::format("no fault that a soak draws is called `{}`; nearest: `{}`",
                                      what, NearestWord(what, known))});
    }
  }
  if (plan.fault.empty() && plan.faults_per_run > 0) {
    problems.push_back({block.where, "soak fault", "is missing: faults_per_run draws from it"});
  }
  return problems;
}

}  // namespace

SoakPlan LoadSoakPlan(const std::filesystem::path& file) {
  const MissionFile text = ParseMission(ReadTextFile(file), file.string());
  const ConfigBlock* block = text.Block("soak");
  if (block == nullptr) {
    throw ConfigError({{.file = file.string(), .line = 0}, "soak", "there is no block `soak`"});
  }
  auto plan = ReadParams<SoakPlan>(*block);
  if (const auto problems = ProblemsOf(plan, *block); !problems.empty())
    throw ConfigError(problems);
  return plan;
}

}  // namespace limpet
