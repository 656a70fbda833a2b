// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/survey_options.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/mission/expectations.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/report/expectation_check.hpp"
#include "limpet/report/paper_tables.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/sweeps/tables_runs.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command TablesForm() {
  Command form{
      .name = "limpet tables",
      .words = "<mission folder>",
      .about =
          "Surveys with many seeds, several at a time, and prints the paper's "
          "tables beside ours. Each run keeps <out>/<seed>/report.json. Seeds already done "
          "are not run again, so that after an interruption or a full disk the same command "
          "goes on. Once a seed is done, the mission, its plugs, the options and the program "
          "must stay as they are (exit code 3 if not). Where the mission has an expect.yaml, "
          "every run is held to its bounds: exit code 1 if fewer runs than its share_of_runs "
          "keep them.",
      .options = {{.names = "--runs",
                   .value = "N",
                   .meaning = "number of seeds",
                   .fallback = "10",
                   .rule = WholeNumber(1)},
                  {.names = "--seed",
                   .value = "N",
                   .meaning = "first seed",
                   .fallback = "1",
                   .rule = WholeNumber(0)},
                  {.names = "--out",
                   .value = "DIR",
                   .meaning = "folder of the runs (default runs/tables-<mission>)",
                   .rule = NotEmpty("a folder")},
                  {.names = "--json", .meaning = "print tables.json instead of the tables"}},
      .takes = "one mission folder, e.g. missions/table1",
      .least_words = 1,
      .most_words = 1};
  std::ranges::move(RunnerCommandOptions(), std::back_inserter(form.options));
  std::ranges::move(SurveyMethodOptions(), std::back_inserter(form.options));
  return form;
}

TablesCommand ReadTablesCommand(const Arguments& given) {
  TablesCommand command;
  command.mission_folder = MissionFolder(given.positionals()[0]);
  command.runs = given.Integer("runs");
  command.first_seed = given.Integer("seed");
  command.out = given.Find("out").value_or("runs/tables-" + command.MissionName());
  command.runner = RunnerOptionsOf(given, command.out);
  command.survey_options = SurveyOptionsGiven(given);
  return command;
}

std::string ReadText(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void SayHowFar(const TablesCommand& command, Reached reached) {
  if (reached == Reached::kInterrupted) {
    fmt::print(stderr, "interrupted: the same command goes on where it stopped\n");
  } else if (reached == Reached::kChanged) {
    fmt::print(stderr,
               "stopped: what is run was changed while it ran; the tables hold the seeds "
               "before. Choose another --out for the new one\n");
  } else if (reached == Reached::kRefused) {
    fmt::print(stderr, "stopped: a run was refused\n");
  } else if (reached == Reached::kDiskFull) {
    fmt::print(stderr,
               "the disk of {} is full: {} of {} seeds are done and kept; make room, then the same "
               "command goes on\n",
               OneLine(command.out.string()), SeedsDone(command), command.runs);
  }
}

RunStatistics Gather(const TablesCommand& command) {
  RunStatistics statistics;
  statistics.mission = command.MissionName();
  for (int seed = command.first_seed; seed < command.first_seed + command.runs; ++seed) {
    if (!fs::exists(command.EndMark(seed))) continue;
    const auto error = statistics.Add(ReadText(command.RunFolder(seed) / "report.json"));
    if (error) statistics.failed.push_back(static_cast<std::uint64_t>(seed));
  }
  return statistics;
}

/// Holds every run to the mission's expect.yaml; says which seed breaks which bound.
bool KeepBounds(const TablesCommand& command, const Expectations& expected) {
  int runs = 0, kept = 0;
  for (int seed = command.first_seed; seed < command.first_seed + command.runs; ++seed) {
    const fs::path report = command.RunFolder(seed) / "report.json";
    if (!fs::exists(command.EndMark(seed)) || !fs::exists(report)) continue;
    const ExpectationCheck check = CheckReport(expected, ReadText(report));
    if (check.is_other_method) return true;
    ++runs;
    kept += check.is_kept() ? 1 : 0;
    for (const std::string& breach : check.breaches) {
      fmt::print(stderr, "seed {}: {}\n", seed, OneLine(breach));
    }
  }
  const bool is_enough = kept >= expected.share_of_runs * runs;
  fmt::print(stderr, "{}: {} of {} runs keep every bound{}\n", expected.file, kept, runs,
             is_enough ? "" : fmt::format("; at least {} of them should", expected.share_of_runs));
  return is_enough;
}

/// The mission to be flown, with the settings that the options of its runs make.
MissionFile MissionOf(const TablesCommand& command) {
  MissionFile mission = LoadMission(command.mission_folder / "mission.moos");
  constexpr std::string_view kSet = "--set=";
  for (const std::string& option : command.survey_options) {
    if (option.starts_with(kSet)) ApplySetting(mission, option.substr(kSet.size()));
  }
  return mission;
}

int MakeTables(const TablesCommand& command, bool prints_json) {
  if (!fs::exists(command.mission_folder / "mission.moos")) {
    throw UsageError(fmt::format("no mission in {}", command.mission_folder.string()));
  }
  const MissionFile mission = MissionOf(command);
  const auto expected = LoadExpectations(
      command.mission_folder, LoadScenario(ScenarioFileOf(mission, command.mission_folder)),
      mission.Global(kVehicleFileGlobal));
  TablesFolder tables = OpenTablesFolder(command);
  const Reached reached = RunSeeds(command, tables);
  const RunStatistics statistics = Gather(command);
  const auto paper_tables = PaperTables(statistics);
  const std::string json = TablesJson(statistics, command.OptionsText());
  fmt::print("{}", prints_json ? json : PlainText(paper_tables));
  SayHowFar(command, reached);
  tables.folder.Write({{"tables.json", json}, {"tables.md", Markdown(paper_tables)}});
  const bool keep_bounds = !expected || KeepBounds(command, *expected);
  if (reached == Reached::kRefused) return kRefused;
  return reached == Reached::kAll && keep_bounds && statistics.failed.empty() ? kOk : kFailed;
}

}  // namespace

int RunTables(std::span<const std::string> args) {
  return RunCommand(TablesForm(), args, [](const Arguments& given) {
    return MakeTables(ReadTablesCommand(given), given.Has("json"));
  });
}

}  // namespace limpet
