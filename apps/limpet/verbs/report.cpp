// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/report.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/report/report.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/report/terminal_report.hpp"
#include "limpet/runs/run_folder.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/scoring/log_replay.hpp"
#include "limpet/session/session_name.hpp"
#include "limpet/session/session_order.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command ReportForm() {
  return {
      .name = "limpet report",
      .words = "<run folder>",
      .about =
          "Scores a run from its logs and writes report.json, figures/ and report.html "
          "anew, also for a run that was cut short.",
      .options = {{.names = "--mission",
                   .value = "DIR",
                   .meaning = "the mission of a run of `limpet launch`, which does not say so"},
                  {.names = "--seed",
                   .value = "N",
                   .meaning = "of such a run",
                   .fallback = "1",
                   .rule = WholeNumber(0)},
                  {.names = "--json", .meaning = "print report.json instead of the table"}},
      .more = R"(A dive whose log has no true poses, or whose mission has no scenario.yaml, is not
judged: what needs the truth is left out.

  limpet report runs/table1-live --mission missions/table1)",
      .takes = "one run folder, e.g. runs/table1-1",
      .least_words = 1,
      .most_words = 1};
}

/// Sessions that left a folder, in the order in which they are told of.
std::vector<std::string> SessionsIn(const fs::path& run) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(run)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !SessionNameProblem(name)) names.push_back(name);
  }
  SortSessions(names);
  return names;
}

struct ReportCommand {
  fs::path run;
  std::optional<fs::path> mission_folder;
  std::uint64_t seed = 1;
  bool prints_json = false;
};

ReportCommand ReadReportCommand(const Arguments& given) {
  if (given.positionals()[0].empty()) throw UsageError("report takes " + ReportForm().takes);
  ReportCommand command;
  command.run = given.positionals()[0];
  if (const auto mission = given.Find("mission")) command.mission_folder = MissionFolder(*mission);
  command.seed = static_cast<std::uint64_t>(given.Integer("seed"));
  command.prints_json = given.Has("json");
  if (!fs::is_directory(command.run)) {
    throw UsageError(fmt::format("{}: no such folder", command.run.string()));
  }
  return command;
}

/// What a run of `limpet launch` does not say about itself. A real dive's mission has no scenario.
RunDescription DescriptionFrom(const ReportCommand& command) {
  const fs::path& folder = *command.mission_folder;
  RunDescription description;
  const bool has_scenario = fs::exists(folder / "scenario.yaml");
  if (has_scenario) description.scenario = LoadScenario(folder / "scenario.yaml");
  ReportSettings& settings = description.settings;
  settings = SettingsOf(LoadMission(folder / "mission.moos"), description.scenario);
  settings.has_scenario = has_scenario;
  settings.mission = MissionName(folder);
  settings.seed = command.seed;
  settings.command = fmt::format("limpet launch missions/{}/mission.moos", settings.mission);
  return description;
}

RunDescription Describe(const ReportCommand& command) {
  RunDescription run = command.mission_folder ? DescriptionFrom(command) : ReadRun(command.run);
  if (run.settings.sessions.empty()) run.settings.sessions = SessionsIn(command.run);
  return run;
}

std::vector<SessionRecord> RecordsOf(const ReportSettings& settings, const fs::path& run) {
  std::vector<SessionRecord> records;
  records.reserve(settings.sessions.size());
  for (const std::string& session : settings.sessions) {
    auto record = RecordFromLog(run / session);
    if (record) {
      records.push_back(*std::move(record));
    } else {
      fmt::print(stderr, "limpet: {}\n", OneLine(record.error().text));
    }
  }
  return records;
}

/// A folder with a log that the run does not count among its sessions is not passed over in
/// silence.
void SayWhatIsLeftOut(const ReportSettings& settings, const fs::path& run) {
  for (const std::string& name : SessionsIn(run)) {
    const bool is_known = std::ranges::find(settings.sessions, name) != settings.sessions.end();
    if (is_known || !RecordFromLog(run / name)) continue;
    fmt::print(stderr,
               "limpet: {} holds a log, but run.json does not have it among the run's sessions: "
               "left out (--mission describes the run anew)\n",
               OneLine((run / name).string()));
  }
}

/// A run of a version that kept no list: what bears a report's names in it is the report's.
void AdoptOldReport(RunFolder& folder, const ReportFiles& files) {
  if (fs::exists(folder.path() / WrittenFiles::kFile) || !fs::exists(folder.path() / "run.json")) {
    return;
  }
  for (const auto& [name, text] : files)
    folder.written().ClaimAllIn(name);
}

int ReportAgain(const Arguments& given) {
  const ReportCommand command = ReadReportCommand(given);
  const RunDescription description = Describe(command);
  RunFolder folder(command.run, RunFolder::Use::kReport);
  const std::vector<SessionRecord> records = RecordsOf(description.settings, command.run);
  SayWhatIsLeftOut(description.settings, command.run);
  if (records.empty()) {
    fmt::print(stderr, "limpet: {} holds no log of a session\n", OneLine(command.run.string()));
    return kFailed;
  }
  const ComposedReport report = ComposeReport(records, description.scenario, description.settings);
  AdoptOldReport(folder, report.files);
  folder.Write(report.files);
  folder.RemoveOtherFigures(report.files);
  if (command.prints_json) {
    fmt::print("{}", report.files.at("report.json"));
  } else {
    PrintReport(report.score);
    fmt::print("\nreport: {}\n", OneLine((command.run / "report.html").string()));
  }
  return kOk;
}

}  // namespace

int RunReport(std::span<const std::string> args) {
  return RunCommand(ReportForm(), args, ReportAgain);
}

}  // namespace limpet
