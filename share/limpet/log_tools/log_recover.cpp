// SPDX-License-Identifier: MIT
// limpet log recover: a sound log of a torn one.
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/log_tools/column_table.hpp"
#include "limpet/log_tools/log_commands.hpp"
#include "limpet/log_tools/log_input.hpp"
#include "limpet/logbook/alog_recovery.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

void PrintRecoveryJson(const LogInput& input, const AlogRecovery& recovery,
                       const CommandOutput& output) {
  const nlohmann::ordered_json out{{"from", input.file().string()},
                                   {"to", output.path().string()},
                                   {"entries", recovery.entries()},
                                   {"other_lines", recovery.other_lines()},
                                   {"damaged_lines", recovery.damaged_lines()},
                                   {"lost_binaries", recovery.lost_binaries()},
                                   {"torn_end", input.reader().has_torn_end()},
                                   {"has_logstart", input.reader().start().has_value()}};
  fmt::print("{}\n", out.dump(1, ' ', isatty(STDOUT_FILENO) != 0,
                              nlohmann::ordered_json::error_handler_t::replace));
}

void PrintText(const LogInput& input, const AlogRecovery& recovery, const CommandOutput& output) {
  fmt::print("{}: {} entries\n", output.path().string(), CountText(recovery.entries()));
  const auto note = [](std::uint64_t count, const char* text) {
    if (count > 0) {
      fmt::print("  {} {}\n", CountText(count), text);
    }
  };
  note(input.reader().has_torn_end() ? 1 : 0, "torn last line left out");
  note(recovery.damaged_lines(), "damaged lines left out");
  note(recovery.lost_binaries(), "binary values left out: their bytes are not in the .blog file");
  note(recovery.other_lines(), "lines kept that are text but no entries");
  if (!input.reader().start()) {
    fmt::print("  the banner is lost: times count from an unknown start\n");
  }
  const fs::path folder = input.file().parent_path();
  for (const auto& [name, size] : recovery.blogs()) {
    if (size && output.path().parent_path() != folder) {
      fmt::print("  binary values stay in {}; keep it beside the log\n",
                 OneLine((folder / name).string()));
    }
  }
}

Command RecoverForm() {
  return {.name = "limpet log recover",
          .words = "<log>",
          .about =
              "Copies what is sound of a log that a kill, a power cut or a bad disk has torn, "
              "and says what was not: the torn last line, lines with bytes that no log "
              "holds, binary values whose bytes are missing. The log itself stays as it is. "
              "Every other command reads torn logs too; recover makes one for tools that do "
              "not.",
          .options = {{.names = "--out",
                       .value = "FILE",
                       .meaning = "where the sound log goes",
                       .is_required = true},
                      {.names = "--force", .meaning = "write over an existing file"},
                      {.names = "--json", .meaning = "what was found, as JSON"}},
          .more = "  limpet log recover run.alog --out sound.alog",
          .takes = "one log and --out FILE",
          .least_words = 1,
          .most_words = 1};
}

int RunRecover(const Arguments& given) {
  LogInput input(given.positionals()[0]);
  CommandOutput output(given.Find("out"), given.Has("force"), input.file());
  AlogRecovery recovery(input.file().parent_path());
  AlogLine line;
  for (AlogEntry entry; input.Next(line, entry);) {
    if (recovery.Keeps(line, entry)) {
      output.Write(line.text);
      output.Write("\n");
    }
  }
  output.Commit();
  if (given.Has("json")) {
    PrintRecoveryJson(input, recovery, output);
  } else {
    PrintText(input, recovery, output);
  }
  return kOk;
}

}  // namespace

const LogCommand kLogRecover{"recover", "a sound log of a torn one", RecoverForm, RunRecover};

}  // namespace limpet
