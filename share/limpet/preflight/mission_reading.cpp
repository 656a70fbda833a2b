// SPDX-License-Identifier: MIT
#include "limpet/preflight/mission_reading.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/behavior_modules.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/mission/expectations.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/stand_ins.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Databases, consoles and what only looks: none of them writes what an app of a vehicle needs.
constexpr std::array kOnlookers{"LimpetDB",      "MOOSDB",   "pLaunch",      "pAntler",
                                "uScope",        "uXMS",     "uMAC",         "uPlay",
                                "pMarineViewer", "pStation", "uProcessWatch"};

/// Runs `work` and keeps the problems it throws.
template <class Work>
void Keep(std::vector<ConfigProblem>& problems, const Work& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    std::ranges::copy(error.problems(), std::back_inserter(problems));
  }
}

const ParamSpec* SpecOf(const std::vector<ParamSpec>& specs, std::string_view key) {
  const auto spec = std::ranges::find_if(
      specs, [key](const ParamSpec& s) { return EqualsIgnoringCase(s.name, key); });
  return spec == specs.end() ? nullptr : &*spec;
}

/// Lines of `key` in a block, or the default; nothing if there is no such parameter.
std::vector<Setting> SettingsIn(const ConfigBlock& block, const std::string& owner,
                                const std::vector<ParamSpec>& specs, std::string_view key) {
  const ParamSpec* spec = SpecOf(specs, key);
  if (spec == nullptr) return {};
  std::vector<Setting> settings;
  for (const ConfigEntry& entry : block.entries) {
    if (EqualsIgnoringCase(entry.key, key)) {
      settings.push_back({.owner = owner,
                          .key = spec->name,
                          .text = entry.value,
                          .unit = spec->unit,
                          .where = entry.where});
    }
  }
  if (settings.empty()) {
    for (const std::string& value : spec->example) {
      settings.push_back({.owner = owner,
                          .key = spec->name,
                          .text = value,
                          .unit = spec->unit,
                          .where = block.where,
                          .is_default = true});
    }
  }
  return settings;
}

/// Where a section of a YAML text begins, as of `errors.fog` or `opis[2]`; npos if it has none.
std::size_t BeginOf(std::string_view section, const std::string& text) {
  std::size_t at = 0;
  if (section.empty()) return at;
  bool is_first = true;  // one of the document, and not one of that name in another
  for (const std::string& part : Split(section, '.')) {
    const std::size_t bracket = part.find('[');
    const std::string name = part.substr(0, bracket) + ":";
    at = is_first && !text.starts_with(name) ? text.find("\n" + name) : text.find(name, at);
    is_first = false;
    if (bracket == std::string::npos) continue;
    const auto index = ParseInteger(part.substr(bracket + 1, part.size() - bracket - 2));
    for (std::int64_t i = 0; i <= index.value_or(0) && at != std::string::npos; ++i)
      at = text.find("- ", at + 1);
  }
  return at;
}

}  // namespace

void internal::RequirePlainFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
    throw ConfigError({{file.string(), 0}, "", "is no plain file: it is not read"});
  }
}

double Setting::number() const { return ParseNumber(text).value_or(0.0); }

std::string Setting::Named() const {
  const std::string file = fs::path(where.file).filename().string();
  const std::string place = is_default       ? "default"
                            : where.line > 0 ? fmt::format("{}:{}", file, where.line)
                                             : file;
  return fmt::format("{} {} = {} ({})", owner, key, text, place);
}

ConfigProblem Setting::Refuse(std::string complaint) const {
  return {where, key, std::move(complaint)};
}

MissionReading::MissionReading(const MissionFile& mission, fs::path folder)
    : mission_(mission), folder_(std::move(folder)) {
  SortLaunches();
  LoadBehaviorFiles();
  LoadTruth();
  LoadVehicle();
}

void MissionReading::SortLaunches() {
  for (const LaunchEntry& launch : mission_.launches) {
    const std::string named = fs::path(launch.binary).filename().string();
    const bool stands_in = IsStoodInFor(named);
    const std::string process = stands_in ? OwnNameOf(named) : named;
    const auto entry = AppRegistry().find(process);
    if (entry == AppRegistry().end()) {
      if (std::ranges::find(kOnlookers, process) == kOnlookers.end()) strangers_.push_back(launch);
      continue;
    }
    const ConfigBlock* own = mission_.Block(launch.moos_name);
    const ConfigBlock* block = own != nullptr ? own : mission_.Block(named);
    const ConfigBlock nothing{.name = process, .where = launch.where, .entries = {}};
    apps_.push_back({.process = process,
                     .entry = &entry->second,
                     .block = block != nullptr ? *block : nothing,
                     .where = launch.where,
                     .stands_for = stands_in ? named : ""});
  }
  // Of two helms ours is the one that is asked about: it may lead the other (lead_check.cpp).
  std::stable_partition(apps_.begin(), apps_.end(),
                        [](const LaunchedApp& a) { return a.stands_for.empty(); });
}

void MissionReading::LoadBehaviorFiles() {
  if (Launches("pHelm")) {
    std::vector<ConfigEntry> foreign;
    for (const Setting& path : FindAll("pHelm", "behavior_path")) {
      foreign.push_back({.key = path.key, .value = path.text, .where = path.where});
    }
    Keep(problems_, [&] { LoadBehaviorModules(foreign, folder_); });
  }
  std::vector<std::string> overrides;
  for (const Setting& setting : FindAll("pHelm", "behavior_setting")) {
    if (!setting.text.empty()) overrides.push_back(setting.text);
  }
  for (const Setting& name : FindAll("pHelm", "behaviors")) {
    if (name.is_default) continue;  // it is required: its lack is a problem of the block
    Keep(problems_, [&] {
      if (!fs::exists(folder_ / name.text)) {
        throw ConfigError(name.Refuse(fmt::format(
            "`{}` cannot be read; it is looked for beside the mission file", name.text)));
      }
      internal::RequirePlainFile(folder_ / name.text);
      behavior_files_.push_back(LoadBehaviors(folder_ / name.text));
      TakeGlobals(mission_.globals, behavior_files_.back().behaviors);
    });
  }
  if (problems_.empty()) {
    Keep(problems_, [&] { ApplyBehaviorSettings(behavior_files_, overrides); });
  }
  for (const BehaviorFile& file : behavior_files_) {
    std::ranges::copy(file.warnings, std::back_inserter(warnings_));
  }
}

void MissionReading::LoadTruth() {
  const auto named = Find("uSimVehicle", "scenario");
  const fs::path file = ScenarioFileOf(mission_, folder_);
  scenario_file_ = file.string();
  if (fs::exists(file)) {
    Keep(problems_, [&] {
      scenario_text_ = ReadTextFile(file);
      // Objects out of the water read well: that is geometry.
      scenario_ = ParseScenario(scenario_text_, scenario_file_, false);
    });
  } else if (named) {
    problems_.push_back(named->Refuse(fmt::format("`{}` cannot be read", named->text)));
  }
  Keep(problems_, [&] {
    static_cast<void>(LoadExpectations(folder_, scenario_.value_or(Scenario{}),
                                       mission_.Global(kVehicleFileGlobal)));
  });
}

void MissionReading::LoadVehicle() {
  const std::string named = mission_.Global(kVehicleFileGlobal);
  if (named.empty()) return;
  vehicle_path_ = FindFactFile(VehicleFacts(), named, folder_);
  std::vector<ConfigProblem> said_by_the_vehicles_check;
  Keep(said_by_the_vehicles_check, [&] { vehicle_ = LoadMissionVehicle(named, folder_); });
}

SourceLine MissionReading::InVehicle(std::string_view key) const {
  for (const ConfigEntry& entry : FactEntries(VehicleFacts(), vehicle_path_)) {
    if (entry.key == key) return entry.where;
  }
  return {.file = vehicle_path_.string(), .line = 0};
}

bool MissionReading::Launches(std::string_view process) const {
  return std::ranges::any_of(apps_, [&](const LaunchedApp& a) { return a.process == process; });
}

bool MissionReading::StandsIn(std::string_view process) const {
  const auto app = std::ranges::find(apps_, process, &LaunchedApp::process);
  return app != apps_.end() && !app->stands_for.empty();
}

bool IsNamesake(std::string_view process) {
  return process == "pShare" || process == "pNodeReporter";
}

bool IsOthersAlone(const MissionFile& mission) {
  return !mission.launches.empty() &&
         std::ranges::none_of(mission.launches, [](const LaunchEntry& launch) {
           const std::string named = fs::path(launch.binary).filename().string();
           return named == "LimpetDB" || (AppRegistry().contains(named) && !IsNamesake(named));
         });
}

bool MissionReading::is_foreign() const {
  return !strangers_.empty() || mission_.launches.empty() ||
         (std::ranges::all_of(apps_, [](const LaunchedApp& a) { return IsNamesake(a.process); }) &&
          std::ranges::find(mission_.launches, "LimpetDB", &LaunchEntry::binary) ==
              mission_.launches.end()) ||
         std::ranges::any_of(apps_, [this](const LaunchedApp& a) { return StandsIn(a.process); });
}

std::vector<Setting> MissionReading::FindAll(std::string_view process, std::string_view key) const {
  const auto app = std::ranges::find(apps_, process, &LaunchedApp::process);
  if (app == apps_.end()) return {};
  return SettingsIn(app->block, app->process, app->entry->describe(), key);
}

std::optional<Setting> MissionReading::Find(std::string_view process, std::string_view key) const {
  std::vector<Setting> all = FindAll(process, key);
  // Of several lines the last one counts, as in ApplyBlock.
  return all.empty() ? std::nullopt : std::optional<Setting>(std::move(all.back()));
}

std::vector<Setting> MissionReading::OfBehaviors(std::string_view type,
                                                 std::string_view key) const {
  std::vector<Setting> settings;
  const auto entry = BehaviorRegistry().find(std::string(type));
  if (entry == BehaviorRegistry().end()) return settings;
  const std::vector<ParamSpec> specs = entry->second.describe();
  for (const BehaviorFile& file : behavior_files_) {
    for (const ConfigBlock& block : file.behaviors) {
      if (block.name != type) continue;
      std::vector<Setting> own = SettingsIn(block, BehaviorNameOf(block), specs, key);
      if (!own.empty()) settings.push_back(std::move(own.back()));
    }
  }
  return settings;
}

SourceLine MissionReading::InScenario(std::string_view text) const { return InScenario("", text); }

SourceLine MissionReading::InScenario(std::string_view section, std::string_view text) const {
  std::string shown;  // without comments
  std::vector<std::size_t> ends;
  for (const TextLine& line : SplitLines(scenario_text_, scenario_file_)) {
    shown += line.text.substr(0, line.text.find('#')) + '\n';
    ends.push_back(shown.size());
  }
  const std::size_t begin = BeginOf(section, shown);
  const std::size_t at = begin == std::string::npos ? begin : shown.find(text, begin);
  if (at == std::string::npos) return {.file = scenario_file_, .line = 0};
  const auto line = std::ranges::upper_bound(ends, at) - ends.begin();
  return {.file = scenario_file_, .line = static_cast<int>(line) + 1};
}

}  // namespace limpet
