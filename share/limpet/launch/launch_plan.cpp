// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_plan.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "limpet/console/command.hpp"
#include "limpet/core/command_line_error.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/launch/launch_rules.hpp"
#include "limpet/mission/expanded_text.hpp"
#include "limpet/mission/outside.hpp"
#include "limpet/mission/stand_ins.hpp"
#include "limpet/preflight/mission_reading.hpp"
#include "limpet/session/session_name.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

std::string TrimmedName(std::string_view line) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) {
    return "";
  }
  std::string_view name = line.substr(0, equals);
  const auto begin = name.find_first_not_of(" \t");
  if (begin == std::string_view::npos) {
    return "";
  }
  name.remove_prefix(begin);
  return std::string(name.substr(0, name.find_last_not_of(" \t") + 1));
}

RestartPolicy PolicyOf(const LaunchEntry& entry, std::vector<ConfigProblem>& problems) {
  const ConfigEntry* option = OptionOf(entry, "Restart");
  if (option == nullptr || EqualsIgnoringCase(option->value, "on_failure")) {
    return RestartPolicy::kOnFailure;
  }
  if (EqualsIgnoringCase(option->value, "always")) {
    return RestartPolicy::kAlways;
  }
  if (!EqualsIgnoringCase(option->value, "never")) {
    problems.push_back(
        {entry.where, "Restart",
         fmt::format("`{}` is not allowed; allowed: never, on_failure, always", option->value)});
  }
  return RestartPolicy::kNever;
}

constexpr double kMostPatience = 3600.0;  // [s]

Seconds HungAfterOf(const LaunchEntry& entry, std::vector<ConfigProblem>& problems) {
  const ConfigEntry* option = OptionOf(entry, "HungAfter_s");
  if (option == nullptr) {
    return LaunchItem::kHungAfter;
  }
  const std::optional<double> seconds = ParseNumber(option->value);
  if (!seconds || (*seconds != 0.0 && (*seconds < 1.0 || *seconds > kMostPatience))) {
    problems.push_back(
        {entry.where, "HungAfter_s",
         fmt::format("`{}` is not allowed; allowed: 1 to 3600 s, 0 for never", option->value)});
    return LaunchItem::kHungAfter;
  }
  return Seconds(*seconds);
}

/// Without these nothing flies, or nothing knows where it is or when to come home.
bool IsVital(const LaunchEntry& entry, bool is_database, std::vector<ConfigProblem>& problems) {
  static constexpr std::array kVital{"pHelm",   "pHelmIvP", "pNav",        "pPilot",
                                     "pSafety", "pSurvey",  "uSimSensors", "uSimVehicle"};
  const ConfigEntry* option = OptionOf(entry, "Vital");
  if (option == nullptr) {
    return is_database || std::ranges::find(kVital, entry.binary) != kVital.end();
  }
  const std::optional<bool> flag = ParseFlag(option->value);
  if (!flag) {
    problems.push_back({entry.where, "Vital",
                        fmt::format("`{}` is not allowed; allowed: true, false", option->value)});
  }
  return flag.value_or(false);
}

/// Words of the block parameter that ExtraProcessParams names.
std::vector<std::string> ExtraArgs(const LaunchEntry& entry, const MissionFile& mission) {
  std::vector<std::string> args;
  const ConfigEntry* option = OptionOf(entry, "ExtraProcessParams");
  const ConfigBlock* antler = mission.Block("ANTLER");
  const ConfigEntry* list =
      option != nullptr && antler != nullptr ? antler->Find(option->value) : nullptr;
  if (list != nullptr) {
    std::istringstream words(list->value);
    for (std::string word; std::getline(words, word, ',');) {
      word.erase(0, word.find_first_not_of(" \t"));
      word.erase(word.find_last_not_of(" \t") + 1);
      args.push_back(word);
    }
  }
  return args;
}

/// Folders that the mission's processes may write to.
std::vector<fs::path> WritableFolders(const LaunchCommand& command) {
  std::vector<fs::path> folders{".", fs::absolute(command.mission_file).parent_path()};
  if (!command.run_folder.empty()) {
    folders.push_back(command.run_folder);
  }
  return folders;
}

/// Whether it finds the mission's files wherever it runs.
bool IsOurs(const fs::path& program, const fs::path& own_folder) {
  return program.parent_path() == own_folder && StandInFor(program.filename().string()) == nullptr;
}

/// One `Run` line: an item, a missing program, or a problem.
void PlanEntry(const LaunchEntry& entry, const LaunchCommand& command, const fs::path& own_folder,
               LaunchPlan& plan, std::vector<ConfigProblem>& problems) {
  if (const auto complaint = ProcessNameProblem(entry.moos_name)) {
    problems.push_back({entry.where, "Run", *complaint});
    return;
  }
  // Missions written for MOOS name its database; ours takes its place.
  const bool is_database = entry.binary == "MOOSDB" || entry.binary == "LimpetDB";
  const std::optional<fs::path> named = ProgramFolder(entry, plan.mission);
  auto problem =
      command.allows_outside ? std::nullopt : ProgramProblem(entry, plan.mission, own_folder);
  if (problem) {
    problems.push_back(*std::move(problem));
    return;
  }
  const std::string binary = is_database ? "LimpetDB" : entry.binary;
  const std::optional<fs::path> folder = command.allows_outside ? named : std::nullopt;
  std::optional<fs::path> program = FindProgram(binary, folder, own_folder);
  if (const ProgramStandIn* stand_in = StandInFor(binary); !program && stand_in != nullptr) {
    program = FindProgram(stand_in->own, folder, own_folder);
  }
  if (!program) {
    plan.missing.push_back({.name = entry.moos_name,
                            .binary = binary,
                            .is_vital = is_database || !IsDispensable(binary),
                            .passed_over = named && !command.allows_outside ? named->string() : "",
                            .where = entry.where});
    return;
  }
  LaunchItem item{.name = entry.moos_name,
                  .program = *program,
                  .args = {},
                  .working_folder = {},
                  .restart = PolicyOf(entry, problems),
                  .is_database = is_database,
                  .hung_after = HungAfterOf(entry, problems),
                  .is_vital = IsVital(entry, is_database, problems)};
  fs::path mission_file = plan.mission_file;
  if (!IsOurs(item.program, own_folder)) {
    mission_file = fs::absolute(mission_file);
    item.working_folder = mission_file.parent_path();
    item.program = fs::absolute(item.program);
  }
  if (OptionOf(entry, "InhibitMOOSParams") == nullptr) {
    item.args = {mission_file.string(), entry.moos_name};
  }
  const std::vector<std::string> extra = ExtraArgs(entry, plan.mission);
  if (const auto complaint = command.allows_outside ? std::nullopt : ArgumentProblem(extra)) {
    problems.push_back({entry.where, "ExtraProcessParams", *complaint});
  }
  std::ranges::copy(extra, std::back_inserter(item.args));
  plan.items.push_back(std::move(item));
}

ConfigProblem NotThere(const MissingProgram& missing, const fs::path& own_folder) {
  return {
      missing.where, "Run",
      fmt::format("no program `{}` in {} nor on PATH{}", missing.binary, own_folder.string(),
                  missing.passed_over.empty()
                      ? ""
                      : fmt::format("; {} is searched with --allow-outside", missing.passed_over))};
}

/// Nothing to launch, nothing of it there, or no database: that is no mission.
void RequireSomething(const LaunchCommand& command, const fs::path& own_folder,
                      const LaunchPlan& plan, std::vector<ConfigProblem>& problems) {
  for (const MissingProgram& missing : plan.missing) {
    if (plan.items.empty() || missing.binary == "LimpetDB") {
      problems.push_back(NotThere(missing, own_folder));
    }
  }
  if (plan.items.empty() && problems.empty()) {
    problems.push_back({{.file = command.mission_file.string(), .line = 0},
                        "ANTLER",
                        "nothing to launch: no `Run = ...` line fits"});
  }
}

/// Text that is nobody's business here is a note; in the block of a program of ours it is a
/// problem.
void AddNotes(const fs::path& own_folder, LaunchPlan& plan, std::vector<ConfigProblem>& problems) {
  const auto is_ours = [&](const std::string& block) {
    // Of other people's missions it is written for MOOS's launcher, which drops what it cannot
    // read.
    return (EqualsIgnoringCase(block, "ANTLER") && !IsOthersAlone(plan.mission)) ||
           std::ranges::any_of(plan.items, [&](const LaunchItem& item) {
             return EqualsIgnoringCase(item.name, block) &&
                    item.program.parent_path() == own_folder;
           });
  };
  plan.notes = NotesOf(plan.mission, is_ours);
  for (const ConfigBlock& block : plan.mission.blocks) {
    if (is_ours(block.name)) {
      std::ranges::copy(block.problems, std::back_inserter(problems));
    }
  }
  for (const MissingProgram& missing : plan.missing) {
    plan.notes.push_back(NotThere(missing, own_folder));
  }
}

std::string TextOfFile(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

LaunchCommand ReadLaunchCommand(const std::vector<std::string>& args) {
  LaunchCommand command;
  for (const std::string& arg : args) {
    const auto equals = arg.find('=');
    const std::string value = equals == std::string::npos ? "" : arg.substr(equals + 1);
    const std::string name = arg.substr(0, equals);
    if (name == "--help" || name == "-h") {
      command.wants_help = true;
    } else if (!arg.starts_with("--")) {
      if (command.mission_file.empty()) {
        command.mission_file = arg;
      } else {
        std::istringstream words(arg);
        for (std::string word; words >> word;) {
          command.only.push_back(word);
        }
      }
    } else if (name == "--quiet" || name == "--terse") {
      command.is_quiet = true;
    } else if (name == "--allow-outside") {
      command.allows_outside = true;
    } else if (name == "--deploy") {
      command.deploys = true;
    } else if (equals == std::string::npos) {
      throw CommandLineError(
          arg,
          "unknown; --Name=value replaces a line of the mission file, --help lists "
          "the options");
    } else if (name == "--run_folder") {
      command.run_folder = value;
    } else if (name == "--prior_folder") {
      command.prior_folder = value;
    } else if (name == "--session") {
      if (const auto problem = SessionNameProblem(value)) {
        throw CommandLineError("--session", problem->text);
      }
      command.session = value;
    } else if (name == "--seed") {
      command.seed = value;
    } else if (name == "--until") {
      command.until = value;
    } else {
      command.replacements.emplace_back(name.substr(2), value);
    }
  }
  if (command.mission_file.empty() && !command.wants_help) {
    throw CommandLineError("mission file", "is missing, e.g. missions/table1/mission.moos");
  }
  if (fs::is_directory(command.mission_file)) {
    command.mission_file /= "mission.moos";
  }
  return command;
}

std::string LaunchHelp(const std::string& caller) {
  return HelpText(
      {.name = caller,
       .words = "<file.moos> [\"nameA nameB\"]",
       .about = "Starts every process of the file's ANTLER block, keeps what each prints in "
                "<run folder>/<name>.log, starts again what fails (with growing pauses), and on "
                "Ctrl-C ends all in order. `Run = pNav @ Restart = never|on_failure|always` says "
                "otherwise for one process. What hangs is killed and started again (`HungAfter_s "
                "= 6`). When an app that the mission cannot do without is given up (`Vital = "
                "true|false`), the vehicle is brought up and the mission is aborted.",
       .options =
           {{.names = "--Name=value",
             .meaning = "replace the lines that set Name, e.g. --MOOSTimeWarp=10; the processes "
                        "then read the copy <file>++"},
            {.names = "--run_folder=DIR",
             .meaning = "default runs/<mission folder>-live, with the file's name if not "
                        "mission.moos; -live-2, -live-3, ... if a former launch left something "
                        "there"},
            {.names = "--session=NAME",
             .meaning = "discovery (default), change, ...; later sessions compare with the "
                        "discovery of the latest dive"},
            {.names = "--prior_folder=DIR",
             .meaning = "later sessions compare with the session saved there"},
            {.names = "--seed=N", .meaning = "for the simulators"},
            {.names = "--deploy", .meaning = "write DEPLOY = true once every process is up"},
            {.names = "--until=VARIABLE",
             .meaning = "end in order as soon as VARIABLE is written, e.g. MISSION_END"},
            {.names = "--allow-outside",
             .meaning = "let the mission start any program and write its logs anywhere; without "
                        "it, only MOOS processes (p, i or u and a capital letter) from beside this "
                        "program and from PATH, and logs below the mission's, the run's and the "
                        "working folder"},
            {.names = "--quiet", .meaning = "say only what goes wrong"}},
       .more = "A program that is not there is said and left out. Exit code 1 if one was vital (no "
               "viewer, no tool)."});
}

std::string WithReplacements(std::string_view text,
                             const std::vector<std::pair<std::string, std::string>>& replacements) {
  std::string result;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string name = TrimmedName(line);
    const auto found = std::ranges::find_if(
        replacements, [&name](const auto& replacement) { return replacement.first == name; });
    result += found == replacements.end()
                  ? std::string(line)
                  : std::string(line.substr(0, line.find('='))) + "= " + found->second;
    result += '\n';
  }
  return result;
}

LaunchPlan PlanLaunch(const LaunchCommand& command, const fs::path& own_folder) {
  LaunchPlan plan;
  plan.mission_file = command.mission_file;
  if (!command.replacements.empty()) {
    const std::string text = ExpandedText(TextOfFile(command.mission_file), command.mission_file);
    plan.mission_file += "++";
    // Half a mission must not be launched.
    if (const std::optional<Error> error =
            WriteDurably(plan.mission_file, WithReplacements(text, command.replacements))) {
      throw CommandLineError("--Name=value", error->text);
    }
  }
  plan.mission = LoadMission(plan.mission_file);
  std::vector<ConfigProblem> problems;
  if (!command.allows_outside) {
    problems = OutsideProblems(plan.mission, WritableFolders(command));
  }
  for (const LaunchEntry& entry : plan.mission.launches) {
    const bool is_wanted = command.only.empty() ||
                           std::ranges::find(command.only, entry.moos_name) != command.only.end();
    if (is_wanted) {
      PlanEntry(entry, command, own_folder, plan, problems);
    }
  }
  RequireSomething(command, own_folder, plan, problems);
  AddNotes(own_folder, plan, problems);
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  const ConfigBlock* antler = plan.mission.Block("ANTLER");
  const ConfigEntry* pause = antler != nullptr ? antler->Find("MSBetweenLaunches") : nullptr;
  plan.between = Seconds(1e-3 * (pause != nullptr ? ParseNumber(pause->value).value_or(0.0) : 0.0));
  plan.warp = ParseNumber(plan.mission.Global("MOOSTimeWarp")).value_or(1.0);
  return plan;
}

}  // namespace limpet
