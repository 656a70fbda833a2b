// SPDX-License-Identifier: MIT
// limpet log scan, limpet log stat: what a log holds.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "limpet/console/exit_code.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/log_tools/column_table.hpp"
#include "limpet/log_tools/entry_filter.hpp"
#include "limpet/log_tools/log_commands.hpp"
#include "limpet/log_tools/log_input.hpp"
#include "limpet/logbook/alog_statistics.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;
using Variables = std::vector<VariableStatistics>;

struct Scanned {
  AlogStatistics statistics;
  Variables variables;
};

Scanned Scan(LogInput& input, EntryFilter& filter) {
  Scanned scanned;
  AlogLine line;
  AlogEntry entry;
  while (input.Next(line, entry)) {
    if (line.kind != AlogLine::Kind::kEntry || filter.Accepts(entry)) {
      scanned.statistics.Add(line, entry);
    }
  }
  scanned.variables = scanned.statistics.Variables();
  return scanned;
}

std::string SourcesText(const VariableStatistics& variable) {
  constexpr std::size_t kMostShown = 3;
  std::string text;
  std::size_t shown = 0;
  for (const std::string& source : variable.sources) {
    if (shown == kMostShown) {
      return text + fmt::format(" +{}", variable.sources.size() - shown);
    }
    text += (shown++ == 0 ? "" : ", ") + source;
  }
  return text;
}

OrderedJson FactsOf(const LogInput& input, const AlogStatistics& all) {
  const AlogReader& reader = input.reader();
  const auto start = reader.start();
  return {{"file", input.file().string()},
          {"bytes", input.size() ? OrderedJson(*input.size()) : OrderedJson(nullptr)},
          {"logstart", start ? OrderedJson(start->value()) : OrderedJson(nullptr)},
          {"entries", all.entries()},
          {"first_s", all.first()},
          {"last_s", all.last()},
          {"out_of_order", all.out_of_order()},
          {"skipped_lines", reader.skipped_lines()},
          {"torn_end", reader.has_torn_end()}};
}

OrderedJson NumbersOf(const NumberStatistics& numbers) {
  return {{"count", numbers.count},
          {"min", numbers.least},
          {"mean", numbers.mean},
          {"max", numbers.greatest},
          {"sd", numbers.StandardDeviation()},
          {"first", numbers.first},
          {"last", numbers.last}};
}

OrderedJson JsonOf(const VariableStatistics& variable) {
  return {
      {"name", variable.name},
      {"entries", variable.entries},
      {"bytes", variable.bytes},
      {"rate_hz", variable.Rate()},
      {"first_s", variable.first},
      {"last_s", variable.last},
      {"longest_gap_s", variable.longest_gap},
      {"sources", variable.sources},
      {"numbers", variable.numbers.count > 0 ? NumbersOf(variable.numbers) : OrderedJson(nullptr)}};
}

void PrintScanJson(const LogInput& input, const Scanned& scanned) {
  OrderedJson out = FactsOf(input, scanned.statistics);
  out["variables"] = OrderedJson::array();
  for (const VariableStatistics& variable : scanned.variables) {
    out["variables"].push_back(JsonOf(variable));
  }
  fmt::print("{}\n",
             out.dump(1, ' ', isatty(STDOUT_FILENO) != 0, OrderedJson::error_handler_t::replace));
}

void PrintHead(const LogInput& input, const Scanned& scanned) {
  const AlogStatistics& all = scanned.statistics;
  fmt::print("{}: {} entries of {} variables, {}\n", OneLine(input.file().string()),
             CountText(all.entries()), scanned.variables.size(),
             BytesText(static_cast<double>(input.size().value_or(all.bytes()))));
  fmt::print("{:.2f} to {:.2f} s", all.first(), all.last());
  if (const auto start = input.reader().start()) {
    fmt::print(" after LOGSTART {:.2f}", start->value());
  }
  if (all.out_of_order() > 0) {
    fmt::print(", {} entries not in order of time", CountText(all.out_of_order()));
  }
  fmt::print("\n\n");
}

void PrintScan(const LogInput& input, const Scanned& scanned) {
  ColumnTable table({{"VARIABLE", false},
                     {"ENTRIES"},
                     {"PER S"},
                     {"SIZE"},
                     {"%"},
                     {"FIRST S"},
                     {"LAST S"},
                     {"BY", false}});
  const double bytes = static_cast<double>(std::max<std::uint64_t>(scanned.statistics.bytes(), 1));
  for (const VariableStatistics& variable : scanned.variables) {
    const double size = static_cast<double>(variable.bytes);
    table.Add({variable.name, CountText(variable.entries), fmt::format("{:.1f}", variable.Rate()),
               BytesText(size), fmt::format("{:.1f}", 100.0 * size / bytes),
               fmt::format("{:.2f}", variable.first), fmt::format("{:.2f}", variable.last),
               SourcesText(variable)});
  }
  PrintHead(input, scanned);
  fmt::print("{}", table.Text(HasColours()));
}

void PrintStat(const LogInput& input, const Scanned& scanned) {
  ColumnTable table({{"VARIABLE", false},
                     {"NUMBERS"},
                     {"MIN"},
                     {"MEAN"},
                     {"MAX"},
                     {"SD"},
                     {"FIRST"},
                     {"LAST"},
                     {"LONGEST GAP S"}});
  std::size_t without = 0;
  for (const VariableStatistics& variable : scanned.variables) {
    const NumberStatistics& n = variable.numbers;
    if (n.count == 0) {
      ++without;
      continue;
    }
    const auto text = [](double value) { return fmt::format("{:.6g}", value); };
    table.Add({variable.name, CountText(n.count), text(n.least), text(n.mean), text(n.greatest),
               text(n.StandardDeviation()), text(n.first), text(n.last),
               fmt::format("{:.2f}", variable.longest_gap)});
  }
  PrintHead(input, scanned);
  fmt::print("{}", table.is_empty() ? "" : table.Text(HasColours()));
  if (without > 0) {
    fmt::print("{}{} variables hold no number\n", table.is_empty() ? "" : "\n", without);
  }
}

void Sort(Variables& variables, const std::string& key) {
  const auto by = [&variables](auto value_of) {
    std::ranges::stable_sort(variables, std::ranges::greater(), value_of);
  };
  if (key == "entries") {
    by(&VariableStatistics::entries);
  } else if (key == "size") {
    by(&VariableStatistics::bytes);
  } else if (key == "rate") {
    by(&VariableStatistics::Rate);
  } else if (key == "first") {
    std::ranges::stable_sort(variables, {}, &VariableStatistics::first);
  } else if (key == "last") {
    std::ranges::stable_sort(variables, {}, &VariableStatistics::last);
  }  // by name they come
}

/// What both commands take, but for what they are about.
Command FormOf(const char* name, const char* about, const char* json, const char* example) {
  Command form{.name = std::string("limpet log ") + name,
               .words = "<log> [VARIABLE ...]",
               .about = about,
               .options = {{.names = "--sort",
                            .value = "KEY",
                            .meaning = "name, entries, size, rate, first or last",
                            .fallback = "name",
                            .rule = OneOf({"name", "entries", "size", "rate", "first", "last"})}},
               .more = example,
               .takes = "a log",
               .least_words = 1};
  std::ranges::move(EntryFilter::Options(), std::back_inserter(form.options));
  form.options.push_back({.names = "--json", .meaning = json});
  return form;
}

Command ScanForm() {
  return FormOf("scan",
                "Lists the variables of a log: entries, rate, share of the file, first and last "
                "time, writers. VARIABLE is a pattern (`*`: anything, `?`: one character).",
                "all facts, with those of `stat`",
                "  limpet log scan runs/table1-1/discovery --sort size");
}

Command StatForm() {
  return FormOf("stat",
                "Says of each variable with numbers how many there are, their least, mean and "
                "greatest value, standard deviation, first and last value, and the longest time "
                "without one. VARIABLE is a pattern (`*`: anything, `?`: one character).",
                "all facts, with those of `scan`", "  limpet log stat run.alog 'NAV_*' --from 60");
}

int Run(const Arguments& given, void (*print)(const LogInput&, const Scanned&)) {
  const std::vector<std::string>& words = given.positionals();
  EntryFilter filter = EntryFilter::Of(given, {words.begin() + 1, words.end()});
  LogInput input(words[0]);
  Scanned scanned = Scan(input, filter);
  Sort(scanned.variables, *given.Find("sort"));
  if (given.Has("json")) {
    PrintScanJson(input, scanned);
  } else {
    print(input, scanned);
    std::fflush(stdout);
    input.PrintDoubts();
  }
  return kOk;
}

int RunScan(const Arguments& given) { return Run(given, PrintScan); }
int RunStat(const Arguments& given) { return Run(given, PrintStat); }

}  // namespace

const LogCommand kLogScan{"scan", "which variables a log holds, how many, how often, by whom",
                          ScanForm, RunScan};
const LogCommand kLogStat{"stat", "least, mean, greatest, spread of the numbers in a log", StatForm,
                          RunStat};

}  // namespace limpet
