// SPDX-License-Identifier: MIT
// limpet log grep, limpet log clip: some lines of a log, as they are.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/log_tools/entry_filter.hpp"
#include "limpet/log_tools/log_commands.hpp"
#include "limpet/log_tools/log_input.hpp"

namespace limpet {
namespace {

struct Form {
  bool is_json = false;
  bool has_comments = true;
  bool is_inverted = false;
};

struct Counts {
  std::uint64_t kept = 0;
  std::uint64_t seen = 0;
  bool has_binaries = false;
};

/// One object per line, for other programs.
std::string JsonLine(const AlogEntry& entry, bool is_ascii) {
  const nlohmann::ordered_json value =
      entry.number ? nlohmann::ordered_json(*entry.number) : nlohmann::ordered_json(entry.value);
  const nlohmann::ordered_json object{{"time", entry.time},
                                      {"name", entry.name},
                                      {"source", entry.source},
                                      {"aux", entry.aux},
                                      {"value", value}};
  return object.dump(-1, ' ', is_ascii, nlohmann::ordered_json::error_handler_t::replace);
}

Counts Copy(LogInput& input, EntryFilter& filter, const Form& form, CommandOutput& output) {
  Counts counts;
  AlogLine line;
  AlogEntry entry;
  while (input.Next(line, entry)) {
    const bool is_entry = line.kind == AlogLine::Kind::kEntry;
    counts.seen += is_entry ? 1 : 0;
    const bool is_kept =
        is_entry ? filter.Accepts(entry) != form.is_inverted
                 : line.kind == AlogLine::Kind::kComment && form.has_comments && !form.is_json;
    if (!is_kept) {
      continue;
    }
    counts.kept += is_entry ? 1 : 0;
    counts.has_binaries = counts.has_binaries || (is_entry && entry.value.starts_with("<MOOS_BIN"));
    if (form.is_json) {
      output.Write(JsonLine(entry, output.is_terminal()) + "\n");
    } else {
      output.WriteLines(line.text);
    }
  }
  return counts;
}

int RunFilter(const Arguments& given, EntryFilter filter, bool is_inverted) {
  LogInput input(given.positionals()[0]);
  CommandOutput output(given.Find("out"), given.Has("force"), input.file());
  // On a terminal the banner only pushes away what was asked for; anywhere else the result is a
  // log.
  const Form form{.is_json = given.Has("json"),
                  .has_comments = !output.is_terminal() && !given.Has("bare"),
                  .is_inverted = is_inverted};
  const Counts counts = Copy(input, filter, form, output);
  const bool is_file = output.is_file();
  output.Commit();
  if (is_file) {
    fmt::print("{}: {} of {} entries\n", output.path().string(), counts.kept, counts.seen);
    if (counts.has_binaries && output.path().parent_path() != input.file().parent_path()) {
      fmt::print("binary values stay in the .blog file; keep that beside it\n");
    }
  } else if (counts.kept == 0) {
    fmt::print(stderr, "no entry of {} matches\n", counts.seen);
  }
  return counts.kept > 0 ? kOk : kFailed;
}

/// Options that both commands have: what is done with the entries.
std::vector<CommandOption> OutputOptions() {
  return {
      {.names = "--out", .value = "FILE", .meaning = "write to FILE"},
      {.names = "--force", .meaning = "write over an existing one"},
      {.names = "--bare", .meaning = "entries alone, without the log's banner (as on a terminal)"},
      {.names = "--json", .meaning = "one JSON object per entry: time, name, source, aux, value"}};
}

Command GrepForm() {
  Command form{.name = "limpet log grep",
               .words = "<log> [VARIABLE ...]",
               .about =
                   "Prints the entries whose variable matches one of the patterns (`*`: "
                   "anything, `?`: one character), as they stand in the log, so that the "
                   "result is a log again.",
               .options = EntryFilter::Options(),
               .more = R"(Exit code 1 if nothing matches.

  limpet log grep run.alog 'NAV_*' DEPLOY
  limpet log grep run.alog CAMERA_FRAME --invert --out small.alog)",
               .takes = "a log and patterns, e.g. run.alog 'NAV_*'",
               .least_words = 1};
  form.options.push_back(
      {.names = "--invert", .meaning = "the other entries: takes variables out of a log"});
  std::ranges::move(OutputOptions(), std::back_inserter(form.options));
  return form;
}

int RunGrep(const Arguments& given) {
  const std::vector<std::string>& words = given.positionals();
  return RunFilter(given, EntryFilter::Of(given, {words.begin() + 1, words.end()}),
                   given.Has("invert"));
}

Command ClipForm() {
  Command form{.name = "limpet log clip",
               .words = "<log>",
               .about =
                   "Prints the entries of some times (both ends included), as they stand in "
                   "the log, so that the result is a log again. Times keep their meaning.",
               .options = EntryFilter::Options(),
               .more = R"(Exit code 1 if there is no such entry.

  limpet log clip run.alog --from 120 --to 180 --out turn.alog)",
               .takes = "one log and --from SECONDS, --to SECONDS or both",
               .least_words = 1,
               .most_words = 1};
  std::ranges::move(OutputOptions(), std::back_inserter(form.options));
  return form;
}

int RunClip(const Arguments& given) {
  if (!given.Has("from") && !given.Has("to")) {
    throw UsageError("log clip takes " + ClipForm().takes);
  }
  return RunFilter(given, EntryFilter::Of(given, {}), false);
}

}  // namespace

const LogCommand kLogGrep{"grep", "entries of some variables", GrepForm, RunGrep};
const LogCommand kLogClip{"clip", "entries between two times", ClipForm, RunClip};

}  // namespace limpet
