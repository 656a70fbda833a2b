// SPDX-License-Identifier: MIT
// The blocks of Limpet's apps and behaviors, each for itself.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/behavior_names.hpp"
#include "limpet/helm/generator_registry.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

void Append(const std::vector<ConfigProblem>& more, std::vector<ConfigProblem>& problems) {
  problems.insert(problems.end(), more.begin(), more.end());
}

void CheckDomain(const LaunchedApp& helm, std::vector<ConfigProblem>& list) {
  std::vector<ConfigEntry> lines;
  std::ranges::copy_if(helm.block.entries, std::back_inserter(lines), [](const ConfigEntry& entry) {
    return EqualsIgnoringCase(entry.key, "domain");
  });
  MotionDomain domain;
  if (!lines.empty()) Append(ReadMotionDomain(lines, helm.block.where, domain), list);
}

void CheckGenerators(const MissionReading& reading, MissionProblems& found) {
  const std::optional<Setting> names = reading.Find("pHelm", "generators");
  if (!names || names->is_default) return;
  for (const std::string& name : NamesOfGenerators(names->text)) {
    if (!GeneratorRegistry().contains(name)) {
      found.syntax.push_back({names->where, names->key, UnknownGenerator(name)});
    }
  }
}

/// Notes lines that set one parameter twice: the last of them counts.
void NoteRepeats(const LaunchedApp& app, MissionProblems& found) {
  for (const ParamSpec& spec : app.entry->describe()) {
    if (spec.is_repeatable) continue;
    const ConfigEntry* former = nullptr;
    for (const ConfigEntry& entry : app.block.entries) {
      if (!EqualsIgnoringCase(entry.key, spec.name)) continue;
      if (former != nullptr) {
        found.notes.push_back({entry.where, entry.key,
                               fmt::format("`{}` counts, not `{}` of {}:{}", entry.value,
                                           former->value, former->where.file, former->where.line)});
      }
      former = &entry;
    }
  }
}

/// What the stock helm refuses as ours does: a key that a behavior of that name does not have, and
/// a name in other letters. A key that is a macro is not one yet.
bool IsRefusedByAnyHelm(const ConfigProblem& problem, const std::vector<BehaviorFile>& files) {
  if (problem.text.starts_with("unknown key in ")) {
    return problem.key.find("$(") == std::string::npos &&
           problem.key.find("%(") == std::string::npos;
  }
  return std::ranges::any_of(files, [&problem](const BehaviorFile& file) {
    return std::ranges::any_of(file.behaviors, [&problem](const ConfigBlock& block) {
      return problem.key == "Behavior" && block.where.file == problem.where.file &&
             block.where.line == problem.where.line && !MisnamedBehavior(block.name).empty();
    });
  });
}

}  // namespace

bool IsForStock(const MissionReading& reading, std::string_view process) {
  return reading.StandsIn(process) || (reading.is_foreign() && IsNamesake(process));
}

std::vector<ConfigProblem>& ListFor(const MissionReading& reading, std::string_view process,
                                    MissionProblems& found) {
  return IsForStock(reading, process) ? found.refused_here : found.syntax;
}

void CheckBlocks(const MissionReading& reading, MissionProblems& found) {
  for (const LaunchedApp& app : reading.apps()) {
    std::vector<ConfigProblem>& list =
        app.stands_for.empty() ? ListFor(reading, app.process, found) : found.refused_here;
    Append(app.entry->check(app.block), list);
    Append(IgnoredKeys(app.block, app.entry->describe()), found.notes);
    Append(AlteredValues(app.block, app.entry->describe()), found.notes);
    NoteRepeats(app, found);
    if (app.process == "pHelm") {
      CheckDomain(app, list);
      CheckGenerators(reading, found);
    }
  }
  for (const auto& [name, entry] : AppRegistry()) {
    const ConfigBlock* block = reading.mission().Block(name);
    if (block != nullptr && !reading.Launches(name)) {
      Append(entry.check(*block), IsForStock(reading, name) ? found.notes : found.syntax);
    }
  }
}

void CheckBehaviors(const MissionReading& reading, MissionProblems& found) {
  std::vector<ConfigProblem>& list = ListFor(reading, "pHelm", found);
  Append(reading.problems(), list);
  Append(reading.warnings(), found.notes);
  if (!reading.problems().empty()) return;
  for (const BehaviorFile& file : reading.behavior_files()) {
    if (file.behaviors.empty() && reading.behavior_files().size() == 1) {
      list.push_back(
          {{.file = file.file, .line = 0}, "", "has no behavior: the vehicle would do nothing"});
    }
  }
  try {
    const BehaviorHost host(reading.behavior_files());
    Append(host.IgnoredLines(), found.notes);
  } catch (const ConfigError& error) {
    for (const ConfigProblem& problem : error.problems()) {
      const bool is_refused = IsRefusedByAnyHelm(problem, reading.behavior_files());
      (is_refused ? found.syntax : list).push_back(problem);
    }
  }
}

}  // namespace limpet::internal
