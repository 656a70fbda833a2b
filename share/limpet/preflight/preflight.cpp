// SPDX-License-Identifier: MIT
#include "limpet/preflight/preflight.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/problem_order.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/behavior_modules.hpp"
#include "limpet/mission/plug.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

void Join(const std::vector<ConfigProblem>& more, std::vector<ConfigProblem>& problems) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// Sorts the problems by file and line, and leaves each once.
void Sort(std::vector<ConfigProblem>& problems) {
  const auto is_same = [](const ConfigProblem& a, const ConfigProblem& b) {
    return OrderOf(a) == OrderOf(b);
  };
  std::ranges::sort(problems, {}, [](const ConfigProblem& problem) { return OrderOf(problem); });
  problems.erase(std::unique(problems.begin(), problems.end(), is_same), problems.end());
}

/// What is missing in several blocks is said once, by a global or the vehicle's file: names it.
void NameGlobals(std::vector<ConfigProblem>& problems) {
  for (ConfigProblem& problem : problems) {
    if (problem.text.find("says it for all") != std::string::npos) continue;
    for (const SharedSetting& shared : SharedSettings()) {
      const bool stands_in = std::ranges::any_of(shared.takers, [&problem](const auto& taker) {
        return problem.key == taker.key &&
               problem.text.starts_with(fmt::format("is missing in {} ", taker.owner));
      });
      if (stands_in)
        problem.text += fmt::format("; the mission's global `{}` says it for all", shared.global);
    }
    for (const FactTaker& taker : VehicleFacts().takers) {
      if (problem.key == taker.key &&
          problem.text.starts_with(fmt::format("is missing in {} ", taker.owner))) {
        problem.text +=
            fmt::format("; the vehicle's file says it for all, by its key {}", taker.fact);
      }
    }
  }
}

MissionProblems Sorted(MissionProblems found) {
  NameGlobals(found.syntax);
  Sort(found.syntax);
  Sort(found.geometry);
  Sort(found.notes);
  Sort(found.refused_here);
  std::erase_if(found.notes, [&found](const ConfigProblem& note) {
    return std::ranges::any_of(found.syntax, [&note](const ConfigProblem& problem) {
      return OrderOf(problem) == OrderOf(note);
    });
  });
  return found;
}

/// Whose block one of our programs reads, also under another name.
bool IsOurs(const MissionFile& mission, const std::string& block) {
  const auto is_registered = [](const std::string& name) {
    return std::ranges::any_of(AppRegistry(), [&name](const auto& registered) {
      return EqualsIgnoringCase(registered.first, name);
    });
  };
  return EqualsIgnoringCase(block, "ANTLER") || is_registered(block) ||
         std::ranges::any_of(mission.launches, [&](const LaunchEntry& launch) {
           return EqualsIgnoringCase(launch.moos_name, block) && is_registered(launch.binary);
         });
}

/// Each `$(NAME)` and `%(NAME)` of a value: nsplug knows both.
std::vector<std::string> MacrosIn(std::string_view text) {
  const auto next = [text](std::size_t from) {
    return std::min(text.find("$(", from), text.find("%(", from));
  };
  std::vector<std::string> macros;
  for (std::size_t at = next(0); at != std::string_view::npos; at = next(at)) {
    const std::size_t end = text.find(')', at);
    if (end == std::string_view::npos) break;
    macros.emplace_back(text.substr(at, end + 1 - at));
    at = end;
  }
  return macros;
}

/// Each macro of the values that a complaint quotes; its own words name what is allowed, as in
/// "no number, literal or $(VARIABLE)".
std::vector<std::string> MacrosQuotedIn(const ConfigProblem& problem) {
  std::vector<std::string> macros;
  const std::vector<std::string> parts = Split(problem.text, '`');
  for (std::size_t quoted = 1; quoted < parts.size(); quoted += 2)
    std::ranges::move(MacrosIn(parts[quoted]), std::back_inserter(macros));
  return macros;
}

/// A template is expanded before it is launched: of a value that is a macro still it is said that
/// the macro is undefined, and not what is wrong with it as a value.
void SetMacrosAside(MissionProblems& found) {
  std::vector<ConfigProblem> undefined;
  const auto set_aside = [&undefined](const ConfigProblem& problem) {
    if (problem.key.starts_with("$(") || problem.key.starts_with("%(")) return false;  // said
    const std::vector<std::string> macros = MacrosQuotedIn(problem);
    for (const std::string& macro : macros)
      undefined.push_back({problem.where, macro, "undefined macro"});
    return !macros.empty();
  };
  std::erase_if(found.syntax, set_aside);
  std::erase_if(found.notes, set_aside);
  std::erase_if(found.refused_here, set_aside);
  std::erase_if(undefined, [&found](const ConfigProblem& macro) {
    return std::ranges::any_of(found.notes, [&macro](const ConfigProblem& note) {
      return note.key == macro.key && note.where.file == macro.where.file &&
             note.where.line == macro.where.line;
    });
  });
  Join(undefined, found.notes);
}

/// Whose value the vehicle's file says, and which is missing since that cannot be read.
bool IsLackOfVehicle(const ConfigProblem& problem) {
  return std::ranges::any_of(VehicleFacts().takers, [&problem](const FactTaker& taker) {
    return problem.key == taker.key &&
           problem.text.starts_with(fmt::format("is missing in {} ", taker.owner));
  });
}

void CheckSyntax(const MissionReading& reading, MissionProblems& found) {
  const MissionFile& mission = reading.mission();
  Join(NotesOf(mission, [&](const std::string& block) { return IsOurs(mission, block); }),
       found.notes);
  internal::CheckLaunches(reading, found);
  internal::CheckBlockNames(reading, found);
  internal::CheckGlobals(reading, found);
  internal::CheckMacros(reading, found);
  const bool has_vehicle = internal::CheckVehicle(reading, found);
  internal::CheckBlocks(reading, found);
  internal::CheckBehaviors(reading, found);
  if (!has_vehicle) std::erase_if(found.syntax, IsLackOfVehicle);
  internal::CheckLead(reading, found);
  internal::CheckScenario(reading, found);
  if (reading.is_foreign()) SetMacrosAside(found);
}

void CheckGeometryOf(const MissionReading& reading, MissionProblems& found) {
  internal::CheckAgreement(reading, found);
  internal::CheckMotion(reading, found);
  if (const std::optional<SurveyFacts> survey = ReadSurveyFacts(reading)) {
    if (!internal::CheckArea(reading, *survey, found)) return;
    internal::CheckView(reading, *survey, found);
    internal::CheckDepths(reading, *survey, found);
    internal::CheckObjects(reading, *survey, found);
    internal::CheckEndurance(reading, *survey, found);
    internal::CheckSafety(reading, *survey, found);
  }
}

/// The missions beside a file, by name, as far as they can be read: their problems are told when
/// they are checked themselves.
std::vector<MissionFile> MissionsBeside(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".moos" && entry.is_regular_file())
      paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<MissionFile> missions;
  for (const fs::path& path : paths) {
    try {
      missions.push_back(LoadMission(path));
    } catch (const ConfigError&) {
      continue;
    }
  }
  return missions;
}

/// A mission, and what it includes that is not there.
struct PartOfMission {
  MissionFile mission;
  std::vector<ConfigProblem> missing;
};

std::string WithoutLine(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line && begin != std::string::npos; ++i) {
    begin = text.find('\n', begin);
    if (begin != std::string::npos) ++begin;
  }
  if (begin == std::string::npos) return text;
  std::string rest = text;
  rest.erase(begin, std::min(text.find('\n', begin), text.size()) - begin);
  return rest;
}

/// Other people's missions are checked without what they include from elsewhere: its folder is told
/// to nsplug. Throws ConfigError, also for a mission of ours.
PartOfMission LoadWithoutMissingIncludes(const fs::path& file) {
  PartOfMission part;
  std::string text = ReadTextFile(file);
  std::optional<ConfigError> first;
  while (true) {
    try {
      part.mission = ReadMission(text, file.string(), MissionPlugOptions(file));
      break;
    } catch (const ConfigError& error) {
      const ConfigProblem problem = error.problems().front();
      const bool is_missing = IsMissingInclude(problem) && problem.where.file == file.string();
      const std::string rest = is_missing ? WithoutLine(text, problem.where.line) : text;
      if (rest.size() == text.size()) throw ConfigError(first.value_or(error));
      if (!first) first = error;
      text = rest;
      part.missing.push_back(problem);
    }
  }
  if (first && !IsOthersAlone(part.mission)) throw ConfigError(*first);
  return part;
}

/// The helm's block, ours or the stock one's; null if there is none.
const ConfigBlock* HelmOf(const MissionFile& mission) {
  const ConfigBlock* own = mission.Block("pHelm");
  return own != nullptr ? own : mission.Block("pHelmIvP");
}

/// The mission beside a behavior file whose helm reads it; null if there is none.
const MissionFile* ReaderOf(const fs::path& file, const std::vector<MissionFile>& missions) {
  const auto reads = [&file](const MissionFile& mission) {
    const ConfigBlock* helm = HelmOf(mission);
    return helm != nullptr && std::ranges::any_of(helm->entries, [&file](const ConfigEntry& entry) {
             return EqualsIgnoringCase(entry.key, "behaviors") &&
                    entry.value == file.filename().string();
           });
  };
  const auto found = std::ranges::find_if(missions, reads);
  return found == missions.end() ? nullptr : &*found;
}

/// Where a mission's helm finds behaviors from elsewhere.
std::vector<ConfigEntry> BehaviorPathsOf(const MissionFile& mission) {
  std::vector<ConfigEntry> paths;
  std::ranges::copy_if(
      HelmOf(mission)->entries, std::back_inserter(paths),
      [](const ConfigEntry& entry) { return EqualsIgnoringCase(entry.key, "behavior_path"); });
  return paths;
}

/// Beside missions of which some are other people's alone, and the rest launches nothing.
bool IsOfOthers(const std::vector<MissionFile>& missions) {
  return std::ranges::any_of(missions, IsOthersAlone) &&
         std::ranges::all_of(missions, [](const MissionFile& mission) {
           return mission.launches.empty() || IsOthersAlone(mission);
         });
}

/// Who a behavior file is for, by the missions beside it.
internal::BehaviorReader ReaderAmong(const std::vector<MissionFile>& missions) {
  if (IsOfOthers(missions)) return internal::BehaviorReader::kOthers;
  const bool has_one = std::ranges::any_of(
      missions, [](const MissionFile& mission) { return !mission.launches.empty(); });
  return has_one ? internal::BehaviorReader::kOurs : internal::BehaviorReader::kUnknown;
}

}  // namespace

MissionProblems CheckLoadedMission(const MissionFile& mission, const fs::path& folder) {
  MissionProblems found;
  const MissionReading reading(mission, folder);
  CheckSyntax(reading, found);
  if (found.syntax.empty()) {  // apps are built from blocks that are right
    const std::vector<ConfigProblem> unbuildable = internal::CheckRoles(reading, found);
    CheckGeometryOf(reading, found);
    if (found.geometry.empty() && found.syntax.empty()) Join(unbuildable, found.syntax);
    if (reading.is_foreign()) SetMacrosAside(found);
  }
  Join(found.refused_here, found.notes);
  return Sorted(std::move(found));
}

MissionProblems CheckMissionFile(const fs::path& file, const MissionChange& change) {
  try {
    internal::RequirePlainFile(file);
    PartOfMission part = LoadWithoutMissingIncludes(file);
    if (change) change(part.mission);
    MissionProblems found = CheckLoadedMission(part.mission, file.parent_path());
    Join(part.missing, found.notes);
    Join(part.missing, found.refused_here);  // a launcher is not told of other folders
    return Sorted(std::move(found));
  } catch (const ConfigError& error) {
    return Sorted({.syntax = error.problems(),
                   .geometry = {},
                   .notes = {},
                   .refused_here = {},
                   .energy = {}});
  }
}

MissionProblems CheckBehaviorFile(const fs::path& file) {
  MissionProblems found;
  try {
    internal::RequirePlainFile(file);
    const std::vector<MissionFile> missions = MissionsBeside(file);
    const MissionFile* mission = ReaderOf(file, missions);
    LoadBehaviorModules(mission == nullptr ? std::vector<ConfigEntry>{} : BehaviorPathsOf(*mission),
                        file.parent_path());
    BehaviorFile behaviors = LoadBehaviors(file);
    if (mission != nullptr) TakeGlobals(mission->globals, behaviors.behaviors);
    Join(behaviors.warnings, found.notes);
    if (behaviors.behaviors.empty() && behaviors.modes.empty() && behaviors.initializes.empty()) {
      found.syntax.push_back({{.file = file.string(), .line = 0}, "", "has no behavior"});
    }
    internal::SetStrangersAside(behaviors, ReaderAmong(missions), found);
    const BehaviorHost host({behaviors});
    Join(host.IgnoredLines(), found.notes);
  } catch (const ConfigError& error) {
    Join(error.problems(), found.syntax);
  }
  SetMacrosAside(found);
  return Sorted(std::move(found));
}

MissionProblems CheckPath(const fs::path& path) {
  if (path.extension() == ".bhv") return CheckBehaviorFile(path);
  if (!fs::is_directory(path)) return CheckMissionFile(path);
  if (fs::exists(path / "mission.moos")) return CheckMissionFile(path / "mission.moos");
  MissionProblems found;
  bool has_mission = false;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    const bool is_fragment = entry.path().filename().string().starts_with("plug_");
    if (entry.path().extension() != ".moos" || is_fragment) continue;
    has_mission = true;
    const MissionProblems more = CheckMissionFile(entry.path());
    Join(more.syntax, found.syntax);
    Join(more.geometry, found.geometry);
    Join(more.notes, found.notes);
    Join(more.refused_here, found.refused_here);
    if (!found.energy) found.energy = more.energy;
  }
  if (!has_mission) {
    found.syntax.push_back({{.file = path.string(), .line = 0}, "", "has no .moos file"});
  }
  return Sorted(std::move(found));
}

}  // namespace limpet
