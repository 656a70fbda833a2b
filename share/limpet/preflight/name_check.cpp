// SPDX-License-Identifier: MIT
// Names that nobody reads: of blocks, of globals, of programs, of macros.
#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/core/word_distance.hpp"
#include "limpet/mission/process_name.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/unused_macros.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

std::vector<std::string> OwnApps() {
  std::vector<std::string> names{"LimpetDB"};
  std::ranges::transform(AppRegistry(), std::back_inserter(names),
                         [](const auto& registered) { return registered.first; });
  return names;
}

bool IsAmong(std::string_view word, const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [word](const auto& w) { return EqualsIgnoringCase(w, word); });
}

/// Stock programs whose names are near one of ours.
const std::vector<std::string>& StockNames() {
  static const std::vector<std::string> names{"uPokeDB", "pHelmIvP",   "pLogger",
                                              "pAntler", "uSimMarine", "uTermCommand",
                                              "pRealm",  "pXRelay",    "pHostInfo"};
  return names;
}

/// Of a word as long as this one letter may be wrong: `pRealm` is not meant to be `pHelm`.
constexpr std::size_t kLettersPerSlip = 4;

/// Two neighbouring letters have changed places.
bool IsTransposed(std::string_view a, std::string_view b) {
  return a.size() == b.size() && WordDistance(a, b) == 2 &&
         std::ranges::is_permutation(a, b, [](char x, char y) {
           return EqualsIgnoringCase({&x, 1}, {&y, 1});
         });
}

/// One of our apps that is launched without a block of its own and whose name is near `name`.
std::string OrphanNear(const MissionReading& reading, const std::string& name) {
  std::vector<std::string> orphans;
  for (const LaunchedApp& app : reading.apps()) {
    if (reading.mission().Block(app.process) == nullptr) orphans.push_back(app.process);
  }
  return SlipOf(name, orphans);
}

/// Apps that turn metres into latitude and longitude, or keep the datum with what they save.
constexpr std::array kNeedDatum{"pNav", "pSession", "pNodeReporter"};

bool NeedsDatum(const MissionReading& reading) {
  return std::ranges::any_of(kNeedDatum, [&](const char* app) { return reading.Launches(app); });
}

struct GlobalRule {
  const char* name;
  double least = 0.0, most = 0.0;  ///< equal: text
};
constexpr std::array kGlobals{GlobalRule{"ServerHost"},
                              GlobalRule{"ServerPort", 1.0, 65535.0},
                              GlobalRule{"Community"},
                              GlobalRule{"MOOSTimeWarp", 1.0, 400.0},
                              GlobalRule{"LatOrigin", -90.0, 90.0},
                              GlobalRule{"LongOrigin", -180.0, 180.0},
                              GlobalRule{"AltOrigin"},
                              GlobalRule{"GlobalLogPath"},
                              GlobalRule{"VehicleFile"}};

void CheckGlobalValue(const ConfigEntry& global, const GlobalRule& rule,
                      std::vector<ConfigProblem>& list) {
  if (rule.least == rule.most) return;
  const std::optional<double> value = ParseNumber(global.value);
  if (!value || !(*value >= rule.least && *value <= rule.most)) {
    list.push_back({global.where, global.key,
                    fmt::format("`{}` is not allowed; allowed: {:g} to {:g}", global.value,
                                rule.least, rule.most)});
  }
}

/// Some trees keep the plugs of a mission in one file, each behind a line `<tag><name>` by which it
/// is included.
bool IsPlugCollection(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) return false;
  const std::vector<std::string> lines = Split(ReadTextFile(file), '\n');
  return std::ranges::any_of(
      lines, [](const std::string& line) { return Trim(line).starts_with("<tag>"); });
}

/// Plugs of a mission, files of other people's apps alone, and those that neither name a vehicle
/// nor have a block, e.g. a datum, are not launched by themselves.
bool IsFragment(const MissionFile& mission) {
  const bool has_own = std::ranges::any_of(
      mission.blocks, [](const ConfigBlock& block) { return IsAmong(block.name, OwnApps()); });
  const bool is_plug =
      std::filesystem::path(mission.file).filename().string().starts_with("plug") ||
      IsPlugCollection(mission.file);
  if (mission.blocks.empty()) {
    const bool is_vehicle =
        !mission.Global("Community").empty() || !mission.Global("ServerPort").empty();
    return !mission.globals.empty() && (is_plug || !is_vehicle);
  }
  return is_plug || !has_own;
}

void CheckThatSomethingRuns(const MissionFile& mission, MissionProblems& found) {
  if (!mission.launches.empty()) return;
  const ConfigBlock* antler = mission.Block("ANTLER");
  auto& list = antler == nullptr && IsFragment(mission) ? found.notes : found.syntax;
  const SourceLine file{.file = mission.file, .line = 0};
  if (mission.blocks.empty()) {
    list.push_back({file, "", "has no ProcessConfig block: nothing can be launched"});
  } else if (antler == nullptr) {
    list.push_back({file, "ANTLER", "is missing: nothing can be launched"});
  } else {
    list.push_back({antler->where, "ANTLER", "has no `Run = ...` line: nothing can be launched"});
  }
}

void CheckMissingGlobals(const MissionReading& reading, MissionProblems& found) {
  if (reading.apps().empty()) return;  // somebody else's mission: its apps know what they need
  const bool is_others = !reading.strangers().empty() || IsOthersAlone(reading.mission());
  auto& list = is_others ? found.notes : found.syntax;
  const auto want = [&](const char* name, const char* reason) {
    if (reading.mission().Global(name).empty()) {
      list.push_back({{.file = reading.mission().file, .line = 0},
                      name,
                      fmt::format("this global is missing: {}", reason)});
    }
  };
  want("Community", "logs, reports and other communities name the vehicle by it");
  if (NeedsDatum(reading)) {
    want("LatOrigin", "positions need a datum (degrees)");
    want("LongOrigin", "positions need a datum (degrees)");
  }
}

void CheckStrangers(const MissionReading& reading, MissionProblems& found) {
  for (const LaunchEntry& stranger : reading.strangers()) {
    const std::string meant =
        IsAmong(stranger.binary, StockNames()) ? "" : SlipOf(stranger.binary, OwnApps());
    if (!meant.empty() && !IsOthersAlone(reading.mission())) {
      found.syntax.push_back(
          {stranger.where, "Run",
           fmt::format("no app `{}`; nearest known: `{}`", stranger.binary, meant)});
    } else {
      found.notes.push_back(
          {stranger.where, stranger.binary,
           fmt::format("is no app of Limpet's: its block is not checked{}",
                       meant.empty() ? "" : fmt::format("; nearest known: `{}`", meant))});
    }
  }
}

}  // namespace

const std::vector<std::string>& StockBehaviors() {
  static const std::vector<std::string> names{
      "BHV_Attractor",     "BHV_AvoidCollision",  "BHV_AvoidObstacles",
      "BHV_AvoidWalls",    "BHV_BearingLine",     "BHV_Convoy",
      "BHV_CutRange",      "BHV_FixedTurn",       "BHV_HSLine",
      "BHV_HeadingBias",   "BHV_HeadingChange",   "BHV_Hysteresis",
      "BHV_MaxSpeed",      "BHV_MemoryTurnLimit", "BHV_OpRegionRecover",
      "BHV_PModelView",    "BHV_RStationKeep",    "BHV_HeadingHysteresis",
      "BHV_PeriodicSpeed", "BHV_MaintainHeading", "BHV_RangePulse",
      "BHV_Shadow",        "BHV_SimpleWaypoint",  "BHV_TimeOut",
      "BHV_Trail",         "BHV_ZigLeg",          "BHV_OpRegionV26",
      "BHV_FixTurn",       "BHV_RubberBand",      "BHV_AvdColregsV17",
      "BHV_AvdColregsV19", "BHV_AvdColregsV22",   "BHV_AvdColregsV26"};
  return names;
}

std::string SlipOf(std::string_view word, const std::vector<std::string>& known) {
  if (IsAmong(word, known)) return "";
  std::vector<std::string> near;  // of about its length, so that two letters are a slip
  std::ranges::copy_if(known, std::back_inserter(near), [word](const std::string& other) {
    return std::max(other.size(), word.size()) - std::min(other.size(), word.size()) <= 2;
  });
  const std::string nearest = NearestWord(word, near);
  if (nearest.empty()) return "";
  const std::size_t letters = std::max(word.size(), nearest.size());
  const std::size_t distance = IsTransposed(word, nearest) ? 1 : WordDistance(word, nearest);
  return distance * kLettersPerSlip <= letters ? nearest : "";
}

void CheckBlockNames(const MissionReading& reading, MissionProblems& found) {
  const MissionFile& mission = reading.mission();
  std::vector<std::string> launched{"ANTLER", "MOOSDB"};
  for (const LaunchEntry& launch : mission.launches) {
    launched.insert(launched.end(), {launch.binary, launch.moos_name});
  }
  std::vector<std::string> known = OwnApps();
  known.emplace_back("ANTLER");
  for (const ConfigBlock& block : mission.blocks) {
    if (IsAmong(block.name, launched)) continue;
    if (IsAmong(block.name, OwnApps())) {
      found.notes.push_back({block.where, block.name, "is not launched; its block has no effect"});
      continue;
    }
    const std::string orphan = OrphanNear(reading, block.name);
    const bool is_stock = IsAmong(block.name, StockNames());
    const std::string meant = !orphan.empty() ? orphan : is_stock ? "" : SlipOf(block.name, known);
    if (!meant.empty()) {
      auto& list = IsOthersAlone(mission) ? found.notes : found.syntax;
      list.push_back({block.where, "ProcessConfig",
                      fmt::format("`{}` is the name of no process that is launched; did "
                                  "you mean `{}`?",
                                  block.name, meant)});
    } else {
      found.notes.push_back(
          {block.where, block.name, "is no app of Limpet's and is not launched here: not checked"});
    }
  }
}

void CheckGlobals(const MissionReading& reading, MissionProblems& found) {
  std::vector<std::string> known;
  std::ranges::transform(kGlobals, std::back_inserter(known), &GlobalRule::name);
  std::ranges::transform(SharedSettings(), std::back_inserter(known), &SharedSetting::global);
  // MOOS takes any value, and a name that ours lack may be read by one of theirs.
  const bool is_others = IsOthersAlone(reading.mission());
  std::vector<ConfigProblem>& names = is_others ? found.notes : found.syntax;
  for (const ConfigEntry& global : reading.mission().globals) {
    const auto rule = std::ranges::find_if(kGlobals, [&global](const GlobalRule& r) {
      return EqualsIgnoringCase(r.name, global.key);
    });
    if (rule != kGlobals.end()) {
      const bool is_read = !std::string_view(rule->name).ends_with("Origin") || NeedsDatum(reading);
      CheckGlobalValue(global, *rule,
                       !is_others ? found.syntax
                       : is_read  ? found.refused_here
                                  : found.notes);
    } else if (const std::string meant = SlipOf(global.key, known);
               !meant.empty() && reading.mission().Global(meant).empty()) {
      names.push_back({global.where, global.key,
                       fmt::format("nothing {}reads this global; did you mean `{}`?",
                                   is_others ? "of Limpet's " : "", meant)});
    }
  }
  CheckMissingGlobals(reading, found);
}

void CheckMacros(const MissionReading& reading, MissionProblems& found) {
  if (reading.apps().empty() || IsOthersAlone(reading.mission())) return;
  std::vector<std::filesystem::path> files{reading.mission().file};
  std::ranges::transform(reading.behavior_files(), std::back_inserter(files), &BehaviorFile::file);
  for (const std::filesystem::path& file : files) {
    for (const UnusedMacro& macro : UnusedMacros(file)) {
      // One more of a series than is read, e.g. a tenth zone, would be dropped and flown into.
      (macro.is_beyond_its_series ? found.syntax : found.notes).push_back(macro.problem);
    }
  }
}

void CheckLaunches(const MissionReading& reading, MissionProblems& found) {
  const MissionFile& mission = reading.mission();
  CheckThatSomethingRuns(mission, found);
  if (const ConfigBlock* antler = mission.Block("ANTLER")) {  // MOOS passes over such lines
    std::ranges::copy(antler->problems,
                      std::back_inserter(IsOthersAlone(mission) ? found.notes : found.syntax));
  }
  std::vector<std::string> names;
  for (const LaunchEntry& launch : mission.launches) {
    if (std::ranges::find(names, launch.moos_name) != names.end()) {
      auto& list = IsAmong(launch.binary, OwnApps()) ? found.syntax : found.notes;
      list.push_back(
          {launch.where, "Run", fmt::format("`{}` is launched twice", launch.moos_name)});
    }
    names.push_back(launch.moos_name);
    if (!IsNameOfMoosProcess(launch.binary)) {
      found.refused_here.push_back(
          {launch.where, "Run",
           fmt::format("`{}` is not the plain name of a MOOS process (p, i or u and a capital "
                       "letter, no path): it is launched with --allow-outside only",
                       launch.binary)});
    }
  }
  for (const LaunchedApp& app : reading.apps()) {
    if (!app.stands_for.empty()) {
      found.notes.push_back(
          {app.where, app.stands_for,
           fmt::format("is no app of Limpet's, and is not installed here: Limpet's "
                       "{} runs in its place, as far as it can",
                       app.process)});
    }
  }
  CheckStrangers(reading, found);
}

}  // namespace limpet::internal
