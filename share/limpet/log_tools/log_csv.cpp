// SPDX-License-Identifier: MIT
// limpet log csv: variables as columns of a table.
#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/log_tools/entry_filter.hpp"
#include "limpet/log_tools/log_commands.hpp"
#include "limpet/log_tools/log_input.hpp"
#include "limpet/logbook/alog_csv.hpp"

namespace limpet {
namespace {

bool IsPattern(const std::string& name) { return name.find_first_of("*?") != std::string::npos; }

/// The columns in the order asked for; a pattern stands for its variables by name. Patterns cost a
/// reading of their own.
std::vector<std::string> ColumnsOf(const std::string& log, const std::vector<std::string>& names) {
  std::vector<std::string> columns;
  for (const std::string& name : names) {
    std::set<std::string, std::less<>> found;
    if (IsPattern(name)) {
      EntryFilter filter(std::vector<std::string>{name});
      LogInput input(log);
      AlogLine line;
      for (AlogEntry entry; input.Next(line, entry);) {
        if (line.kind == AlogLine::Kind::kEntry && filter.Accepts(entry) &&
            !found.contains(entry.name)) {
          found.emplace(entry.name);
        }
      }
    } else {
      found.insert(name);
    }
    for (const std::string& column : found) {
      if (std::ranges::find(columns, column) == columns.end()) {
        columns.push_back(column);
      }
    }
  }
  return columns;
}

/// Empties `text`.
void WriteRows(std::string& text, CommandOutput& output) {
  if (!text.empty()) {
    output.WriteLines(std::string_view(text).substr(0, text.size() - 1));
    text.clear();
  }
}

Command CsvForm() {
  Command form{
      .name = "limpet log csv",
      .words = "<log> VARIABLE ...",
      .about =
          "Writes a CSV table: `time` (seconds since the start of the log), then a column "
          "per variable. A pattern (`*`, `?`) stands for its variables by name. Rows follow "
          "the log's order of arrival.",
      .options = {{.names = "--join",
                   .value = "HOW",
                   .meaning = "none: a row per entry, the other cells empty; last: a row per "
                              "instant, every cell with its variable's last value",
                   .fallback = "none",
                   .rule = OneOf({"none", "last"})},
                  {.names = "--out", .value = "FILE", .meaning = "write to FILE"},
                  {.names = "--force", .meaning = "write over an existing one"}},
      .more = R"(Exit code 1 if there is no row.

  limpet log csv run.alog NAV_X NAV_Y NAV_DEPTH --join last --out track.csv)",
      .takes = "a log and variables, e.g. run.alog NAV_X NAV_Y",
      .least_words = 2};
  std::ranges::move(EntryFilter::Options(), std::back_inserter(form.options));
  return form;
}

int RunCsv(const Arguments& given) {
  const std::vector<std::string>& words = given.positionals();
  const AlogCsv::Join join =
      *given.Find("join") == "last" ? AlogCsv::Join::kLast : AlogCsv::Join::kNone;
  EntryFilter filter = EntryFilter::Of(given, {});
  const std::vector<std::string> names(words.begin() + 1, words.end());
  if (words[0] == "-" && std::ranges::any_of(names, IsPattern)) {
    throw UsageError("log csv cannot read the standard input twice, as patterns need");
  }
  AlogCsv table(ColumnsOf(words[0], names), join);
  LogInput input(words[0]);
  CommandOutput output(given.Find("out"), given.Has("force"), input.file());
  std::string text;
  table.AppendHeader(text);
  AlogLine line;
  for (AlogEntry entry; input.Next(line, entry);) {
    if (line.kind == AlogLine::Kind::kEntry && filter.Accepts(entry)) {
      table.Append(text, entry);
      WriteRows(text, output);
    }
  }
  table.AppendRest(text);
  WriteRows(text, output);
  const bool is_file = output.is_file();
  output.Commit();
  if (is_file) {
    fmt::print("{}: {} rows\n", output.path().string(), table.rows());
  }
  if (table.rows() == 0) {
    fmt::print(stderr, "{}: no entry of these variables\n", input.file().string());
  }
  return table.rows() > 0 ? kOk : kFailed;
}

}  // namespace

const LogCommand kLogCsv{"csv", "variables as columns of a table", CsvForm, RunCsv};

}  // namespace limpet
