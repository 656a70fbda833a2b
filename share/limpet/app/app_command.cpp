// SPDX-License-Identifier: MIT
#include "limpet/app/app_command.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/command_line_error.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/mission/outside.hpp"

namespace limpet {
namespace {

struct Switch {
  const char* name;
  const char* meaning;
};

constexpr std::array kSwitches{
    Switch{"moos_host", "host of the database (default: ServerHost, else localhost)"},
    Switch{"moos_port", "port of the database (default: ServerPort, else 9000)"},
    Switch{"moos_name", "name in the community (default: the process's); also --alias="},
    Switch{"alias", "the same as --moos_name"},
    Switch{"moos_community", "name of the community (a database's alone)"},
    Switch{"moos_time_warp", "MOOSTimeWarp, 1 to 400"},
    Switch{"moos_mission_file", "mission file; also the first word"},
    Switch{"moos_app_tick", "AppTick [Hz]"},
    Switch{"moos_comms_tick", "accepted; communication is asynchronous"},
    Switch{"moos_max_app_tick", "MaxAppTick [Hz]"},
    Switch{"moos_iterate_mode", "IterateMode"},
    Switch{"moos_tw_delay_factor", "accepted; mail is never held back"},
    Switch{"run_folder", "where this run's output goes (LIMPET_RUN_FOLDER)"},
    Switch{"prior_folder", "former session to compare with (LIMPET_PRIOR_FOLDER)"},
    Switch{"session", "discovery, change, ... (LIMPET_SESSION)"},
    Switch{"seed", "of every random draw (LIMPET_SEED)"},
    Switch{"allow_outside", "the mission's logs may lie anywhere (LIMPET_ALLOW_OUTSIDE)"},
};

/// Those of one app alone: switch and key.
std::map<std::string, std::string> OwnSwitches(const std::string& process) {
  const auto entry = AppRegistry().find(process);
  return entry == AppRegistry().end() ? std::map<std::string, std::string>()
                                      : entry->second.switches;
}

std::vector<std::string> SwitchNames(const std::string& process) {
  std::vector<std::string> names{"help", "example"};
  for (const auto& [name, key] : OwnSwitches(process)) {
    names.push_back(name);
  }
  for (const Switch& known : kSwitches) {
    names.emplace_back(known.name);
  }
  return names;
}

ConfigError Refusal(const std::string& name, const std::string& value, const std::string& allowed) {
  return CommandLineError("--" + name,
                          fmt::format("`{}` is not allowed; allowed: {}", value, allowed));
}

double NumberOf(const std::string& name, const std::string& value, double least, double most) {
  const std::optional<double> number = ParseNumber(value);
  if (!number || !(*number >= least && *number <= most)) {
    throw Refusal(name, value, fmt::format("{:g} to {:g}", least, most));
  }
  return *number;
}

std::string Environment(const char* name, const std::string& otherwise = "") {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before any thread
  return value != nullptr ? value : otherwise;
}

/// Words and `--key=value` pairs in order.
struct Words {
  std::vector<std::string> positionals;
  std::vector<std::pair<std::string, std::string>> switches;
};

Words Split(const std::string& process, std::span<const char* const> args) {
  Words words;
  for (const std::string arg : args) {
    if (!arg.starts_with("-")) {
      words.positionals.push_back(arg);
      continue;
    }
    const std::string body = arg.substr(arg.starts_with("--") ? 2 : 1);
    const auto equals = body.find('=');
    const std::string name = body.substr(0, equals);
    const std::vector<std::string> known = SwitchNames(process);
    if (std::ranges::find(known, name) == known.end()) {
      throw CommandLineError(arg,
                             fmt::format("unknown; nearest known: --{}", NearestWord(name, known)));
    }
    words.switches.emplace_back(name, equals == std::string::npos ? "" : body.substr(equals + 1));
  }
  return words;
}

void ApplyGlobals(AppCommand& command) {
  const auto global = [&command](std::string_view key) { return command.mission.Global(key); };
  if (const std::string host = global("ServerHost"); !host.empty()) {
    command.host = host;
  }
  if (const std::string port = global("ServerPort"); !port.empty()) {
    command.port = static_cast<std::uint16_t>(NumberOf("ServerPort", port, 1, 65535));
  }
  if (const std::string community = global("Community"); !community.empty()) {
    command.community = community;
  }
  if (const std::string warp = global("MOOSTimeWarp"); !warp.empty()) {
    command.warp = NumberOf("MOOSTimeWarp", warp, 1, 400);
  }
}

void ApplySwitch(AppCommand& command, const std::string& name, const std::string& value) {
  const auto override_key = [&](const char* key) {
    command.overrides.push_back({.key = key, .value = value, .where = CommandLine()});
  };
  if (name == "moos_host") {
    command.host = value;
  } else if (name == "moos_port") {
    command.port = static_cast<std::uint16_t>(NumberOf(name, value, 0, 65535));
  } else if (name == "moos_name" || name == "alias") {
    command.name = value;
  } else if (name == "moos_community") {
    command.community = value;
  } else if (name == "moos_time_warp") {
    command.warp = NumberOf(name, value, 1, 400);
  } else if (name == "moos_app_tick") {
    override_key("AppTick");
  } else if (name == "moos_max_app_tick") {
    override_key("MaxAppTick");
  } else if (name == "moos_iterate_mode") {
    override_key("IterateMode");
  } else if (name == "run_folder") {
    command.run_folder = value;
  } else if (name == "prior_folder") {
    command.prior_folder = value;
  } else if (name == "session") {
    command.session = value;
  } else if (name == "seed") {
    command.seed = static_cast<std::uint64_t>(NumberOf(name, value, 0, 9e15));
  } else if (name == "allow_outside") {
    command.allows_outside = value != "false";
  } else if (name == "help") {
    command.wants_help = true;
  } else if (name == "example") {
    command.wants_example = true;
  }
}

/// The name is that of files in the run folder; a logger's mission says where it writes.
void RequireInside(const AppCommand& command) {
  if (const auto complaint = ProcessNameProblem(command.name)) {
    throw CommandLineError("name", *complaint);
  }
  if (command.process != "pLog" || command.allows_outside) {
    return;
  }
  std::vector<std::filesystem::path> folders{"."};
  if (!command.mission_file.empty()) {
    folders.push_back(std::filesystem::absolute(command.mission_file).parent_path());
  }
  if (!command.run_folder.empty()) {
    folders.push_back(command.run_folder);
  }
  const std::vector<ConfigProblem> problems = OutsideProblems(command.mission, folders);
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
}

}  // namespace

AppCommand ReadAppCommand(const std::string& process, std::span<const char* const> args) {
  const Words words = Split(process, args);
  if (words.positionals.size() > 2) {
    throw CommandLineError(words.positionals[2], "at most a mission file and a name are expected");
  }
  AppCommand command{.process = process,
                     .name = process,
                     .mission_file = {},
                     .mission = {},
                     .overrides = {},
                     .additions = {},
                     .run_folder = Environment("LIMPET_RUN_FOLDER"),
                     .prior_folder = Environment("LIMPET_PRIOR_FOLDER"),
                     .session = Environment("LIMPET_SESSION", "discovery"),
                     .is_restarted = !Environment("LIMPET_RESTARTED").empty(),
                     .allows_outside = !Environment(kAllowOutside).empty()};
  ApplySwitch(command, "seed", Environment("LIMPET_SEED", "1"));
  if (!words.positionals.empty()) {
    command.mission_file = words.positionals[0];
  }
  for (const auto& [name, value] : words.switches) {
    if (name == "moos_mission_file") {
      command.mission_file = value;
    }
  }
  if (!command.mission_file.empty()) {
    command.mission = LoadMission(command.mission_file);
    ApplyGlobals(command);
  }
  if (words.positionals.size() == 2) {
    command.name = words.positionals[1];
  }
  const std::map<std::string, std::string> own = OwnSwitches(process);
  for (const auto& [name, value] : words.switches) {
    if (const auto key = own.find(name); key != own.end()) {
      command.additions.push_back({key->second, value, CommandLine()});
    } else {
      ApplySwitch(command, name, value);
    }
  }
  RequireInside(command);
  return command;
}

std::string AppCommandHelp(const std::string& process) {
  std::string text = fmt::format("usage: {} [mission.moos] [name] [options]\n\n", process);
  for (const Switch& known : kSwitches) {
    text += fmt::format("  --{:<24}{}\n", fmt::format("{}=", known.name), known.meaning);
  }
  for (const auto& [name, key] : OwnSwitches(process)) {
    text += fmt::format("  -{:<25}one more line `{} = ...` of its block\n", name + "=", key);
  }
  text += fmt::format("  --{:<24}{}\n  --{:<24}{}\n", "example",
                      "print a ProcessConfig block with every parameter", "help", "this text");
  return text;
}

}  // namespace limpet
