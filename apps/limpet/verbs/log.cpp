// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/log.hpp"

#include <array>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/core/config.hpp"
#include "limpet/log_tools/log_commands.hpp"

namespace limpet {
namespace {

constexpr std::array kCommands{&kLogScan, &kLogStat,    &kLogGrep,  &kLogClip,
                               &kLogCsv,  &kLogRecover, &kLogRawlog};

void PrintHelp() {
  fmt::print("usage: limpet log <command> <log> [options]\n\n");
  for (const LogCommand* command : kCommands) {
    fmt::print("  {:<10} {}\n", command->name, command->summary);
  }
  fmt::print(
      "\n<log> is an .alog file, ours or MOOS's, also as .gz; a folder that holds one,\n"
      "itself or below, as a run folder does; or - for the standard input.\n"
      "`limpet log <command> --help` says more.\n");
}

const LogCommand& CommandNamed(const std::string& word) {
  std::vector<std::string> names;
  for (const LogCommand* command : kCommands) {
    if (word == command->name) {
      return *command;
    }
    names.emplace_back(command->name);
  }
  const std::string nearest = NearestWord(word, names);
  throw UsageError(
      fmt::format("no command `log {}`{}; `limpet log --help` lists them", word,
                  nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
}

}  // namespace

int RunLog(std::span<const std::string> args) {
  if (args.empty() || args[0] == "--help" || args[0] == "-h") {
    PrintHelp();
    return args.empty() ? kUsage : kOk;
  }
  const LogCommand& command = CommandNamed(args[0]);
  return RunCommand(command.form(), args.subspan(1), command.run);
}

}  // namespace limpet
