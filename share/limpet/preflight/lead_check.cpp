// SPDX-License-Identifier: MIT
// A survey led through another helm: whether that one is there and hears.
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/helm/behavior_host.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLed = "pHelmIvP";

/// The behaviors of the helm that is led; problems of its files are found.syntax. They are read as
/// its program reads them: a type that is not ours may be there.
std::vector<ConfigBlock> LedBehaviors(const MissionReading& reading, const ConfigBlock& helm,
                                      MissionProblems& found) {
  std::vector<ConfigBlock> behaviors;
  for (const ConfigEntry& entry : helm.entries) {
    if (!EqualsIgnoringCase(entry.key, "behaviors")) continue;
    try {
      const fs::path path = reading.folder() / entry.value;
      if (!fs::exists(path)) {
        throw ConfigError(
            {entry.where, entry.key,
             fmt::format("`{}` cannot be read; it is looked for beside the mission file",
                         entry.value)});
      }
      const BehaviorFile file = LoadBehaviors(path);
      std::ranges::copy(file.behaviors, std::back_inserter(behaviors));
      std::ranges::copy(file.warnings, std::back_inserter(found.notes));
    } catch (const ConfigError& error) {
      std::ranges::copy(error.problems(), std::back_inserter(found.syntax));
    }
  }
  return behaviors;
}

/// What stands for a setting that says a variable, empty if it says none.
std::string VariableIn(const std::optional<Setting>& setting) {
  return setting && !setting->is_default ? setting->text : "";
}

/// That a behavior of `type` takes updates in the variable that `setting` says.
void CheckTaken(const Setting& setting, std::string_view type,
                const std::vector<ConfigBlock>& behaviors, MissionProblems& found) {
  std::vector<std::string> taken;
  for (const ConfigBlock& block : behaviors) {
    const ConfigEntry* updates = block.Find("updates");
    if (block.name == type && updates != nullptr) taken.push_back(updates->value);
  }
  if (std::ranges::find(taken, setting.text) != taken.end()) return;
  const std::string nearest = NearestWord(setting.text, taken);
  found.syntax.push_back(setting.Refuse(fmt::format(
      "no {} of {} takes updates in `{}`{}", type, kLed, setting.text,
      nearest.empty() ? fmt::format("; give it a line `updates = {}`", setting.text)
                      : fmt::format("; the nearest that one takes them in: `{}`", nearest))));
}

/// What ours would refuse in the other helm's files is a note: the stock one may take it.
void NoteProblems(const std::vector<ConfigBlock>& behaviors, MissionProblems& found) {
  try {
    BehaviorFile file;
    file.behaviors = behaviors;
    const BehaviorHost host({file});
    const std::vector<ConfigProblem> ignored = host.IgnoredLines();
    found.notes.insert(found.notes.end(), ignored.begin(), ignored.end());
  } catch (const ConfigError& error) {
    found.notes.insert(found.notes.end(), error.problems().begin(), error.problems().end());
  }
}

}  // namespace

void CheckLead(const MissionReading& reading, MissionProblems& found) {
  struct Told {
    const char *key, *type;
  };
  static constexpr std::array kTold{
      Told{"lead", "BHV_Waypoint"}, Told{"lead_depth", "BHV_ConstantDepth"},
      Told{"lead_course", "BHV_ConstantHeading"}, Told{"lead_speed", "BHV_ConstantSpeed"}};
  std::vector<std::pair<Setting, const char*>> told;
  for (const Told& one : kTold) {
    const std::optional<Setting> setting = reading.Find("pHelm", one.key);
    if (!VariableIn(setting).empty()) told.emplace_back(*setting, one.type);
  }
  if (told.empty()) return;
  if (told.front().first.key != "lead") {
    for (const auto& [setting, type] : told) {
      found.syntax.push_back(setting.Refuse("says nothing without `lead`: nobody is led"));
    }
    return;
  }
  const auto is_led = [](const LaunchEntry& launch) {
    return EqualsIgnoringCase(launch.moos_name, kLed);
  };
  if (std::ranges::none_of(reading.mission().launches, is_led)) {
    found.syntax.push_back(told.front().first.Refuse(
        fmt::format("leads another helm, and {} is not launched: nobody would steer", kLed)));
    return;
  }
  const ConfigBlock* helm = reading.mission().Block(kLed);
  if (helm == nullptr) return;  // told by who checks it
  const std::vector<ConfigBlock> behaviors = LedBehaviors(reading, *helm, found);
  for (const auto& [setting, type] : told) {
    CheckTaken(setting, type, behaviors, found);
  }
  NoteProblems(behaviors, found);
}

}  // namespace limpet::internal
