// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/survey.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <malloc.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/survey_options.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/report/expectation_check.hpp"
#include "limpet/report/report.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/report/survey_progress.hpp"
#include "limpet/report/terminal_report.hpp"
#include "limpet/runs/flown_mission.hpp"
#include "limpet/runs/mission_check.hpp"
#include "limpet/runs/run_folder.hpp"
#include "limpet/runs/run_settings.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/scoring/log_replay.hpp"
#include "limpet/session/session_name.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command SurveyForm() {
  Command form{
      .name = "limpet survey",
      .words = "<mission folder>",
      .about =
          "Surveys the mission's area once per session (embedded, on virtual time, no port "
          "opened), compares the sessions, and reports what is confirmed, new or removed. "
          "Where the mission has an expect.yaml, the report is held to its bounds: exit code "
          "1 if one is broken.",
      .options = {{.names = "--seed",
                   .value = "N",
                   .meaning = "every random draw comes from it",
                   .fallback = "1",
                   .rule = WholeNumber(0)},
                  {.names = "--out",
                   .value = "DIR",
                   .meaning = "run folder (default runs/<mission>-<seed>); an earlier run in it is "
                              "replaced, and nothing else is removed",
                   .rule = NotEmpty("a folder")}},
      .takes = "one mission folder, e.g. missions/table1",
      .least_words = 1,
      .most_words = 1};
  std::ranges::move(SurveyMethodOptions(), std::back_inserter(form.options));
  return form;
}

struct SurveyCommand {
  fs::path mission_folder;
  std::string mission_name;
  std::uint64_t seed = 1;
  fs::path out;
  std::vector<std::string> sessions;
  std::vector<std::string> settings;
  std::string planner, gain;
  bool delivers_truth_on_board = true;
  std::string command_line;
};

SurveyCommand ReadSurveyCommand(const Arguments& given) {
  SurveyCommand command;
  command.mission_folder = MissionFolder(given.positionals()[0]);
  command.mission_name = MissionName(command.mission_folder);
  command.seed = static_cast<std::uint64_t>(given.Integer("seed"));
  command.out =
      given.Find("out").value_or(fmt::format("runs/{}-{}", command.mission_name, command.seed));
  command.sessions = Split(*given.Find("sessions"), ',');
  command.settings = given.All("set");
  command.planner = given.Find("planner").value_or("");
  command.gain = given.Find("gain").value_or("");
  command.delivers_truth_on_board = !given.Has("without-truth");
  for (const auto& [option, value] :
       {std::pair{"planner", command.planner}, std::pair{"gain", command.gain}}) {
    if (!value.empty()) {
      command.settings.push_back(fmt::format("pHelm.{}={}", option, value));
    }
  }
  command.command_line =
      fmt::format("limpet survey missions/{} --seed {}", command.mission_name, command.seed);
  if (given.Has("sessions")) {
    command.command_line += fmt::format(" --sessions {}", fmt::join(command.sessions, ","));
  }
  for (const std::string& setting : command.settings) {
    command.command_line += " --set " + setting;
  }
  return command;
}

/// Sessions of an earlier run in this folder that go on counting: those before the first that is
/// run again. A session that is run alone is compared with the last of them.
std::vector<std::string> KeptSessions(RunFolder& folder, const SurveyCommand& command) {
  std::vector<std::string> kept;
  const std::vector<std::string>& again = command.sessions;
  if (again.front() == "discovery" || !folder.written().Owns("run.json")) return kept;
  const ReportSettings earlier = ReadRun(folder.path()).settings;
  for (const std::string& session : earlier.sessions) {
    if (std::ranges::find(again, session) != again.end()) break;
    if (fs::is_directory(folder.path() / session)) kept.push_back(session);
  }
  if (!kept.empty() && earlier.mission != command.mission_name) {
    throw Refusal(
        fmt::format("{} holds sessions of the mission {}: {} cannot be compared with them",
                    OneLine(folder.path().string()), OneLine(earlier.mission), again.front()));
  }
  return kept;
}

MissionFile SurveyMission(const SurveyCommand& command) {
  MissionFile mission = LoadMission(FlownMissionAt(command.mission_folder));
  for (const std::string& setting : command.settings) {
    ApplySetting(mission, setting);
  }
  return mission;
}

class SurveyRun {
 public:
  explicit SurveyRun(SurveyCommand command)
      : command_(std::move(command)),
        mission_(SurveyMission(command_)),
        scenario_(LoadScenario(ScenarioFileOf(mission_, command_.mission_folder))) {
    expectations_ =
        LoadExpectations(command_.mission_folder, scenario_, mission_.Global(kVehicleFileGlobal));
    // Everything is checked before the run folder is touched: a slip must not cost an earlier run.
    if (const auto problem = SessionListProblem(command_.sessions, SessionsOf(scenario_))) {
      throw UsageError("--sessions: " + problem->text);
    }
    Refuse(CheckConfiguration(mission_, command_.mission_folder));
    settings_ = SettingsOf(mission_, scenario_);
    settings_.mission = command_.mission_name;
    settings_.seed = command_.seed;
    settings_.command = command_.command_line;
    Refuse(CheckGeometry(mission_, command_.mission_folder));
  }

  int Run() {
    RunFolder folder(command_.out, RunFolder::Use::kNewRun);
    settings_.sessions = KeptSessions(folder, command_);
    std::string former = settings_.sessions.empty() ? "" : settings_.sessions.back();
    // A record of hours is not to be copied where the next one begins.
    records_.reserve(settings_.sessions.size() + command_.sessions.size());
    TakeRecordsOf(settings_.sessions, folder);
    folder.MakeRoomFor(command_.sessions, settings_.sessions);
    settings_.sessions.insert(settings_.sessions.end(), command_.sessions.begin(),
                              command_.sessions.end());
    folder.Write(RunDescriptionFiles(settings_, scenario_));
    for (const std::string& session : command_.sessions) {
      if (interrupt_requested) break;
      RunOne(folder, session, former);
      former = session;
    }
    return Finish(folder);
  }

 private:
  /// The report is of the whole run: what was flown earlier and is kept is in its logs.
  void TakeRecordsOf(const std::vector<std::string>& kept, const RunFolder& folder) {
    if (kept.empty()) return;
    const std::map<std::string, double> wall_s = ReadRun(folder.path()).settings.wall_s;
    for (const std::string& session : kept) {
      auto record = RecordFromLog(folder.path() / session);
      if (!record) {
        fmt::print(stderr, "limpet: {}\n", OneLine(record.error().text));
        continue;
      }
      records_.push_back(*std::move(record));
      if (const auto wall = wall_s.find(session); wall != wall_s.end()) {
        settings_.wall_s.insert(*wall);
      }
    }
  }

  /// Compares with expect.yaml and says what it breaks.
  [[nodiscard]] bool KeepsBounds(const RunScore& score) const {
    if (!expectations_) return true;
    const ExpectationCheck check = CheckReport(*expectations_, ReportJson(score));
    if (check.is_other_method) {
      fmt::print("{} is for planner {} with gain full: not compared\n", expectations_->file,
                 expectations_->planner);
    } else if (check.is_kept()) {
      fmt::print("{}: all {} bounds are kept\n", expectations_->file, check.compared);
    }
    for (const std::string& breach : check.breaches) {
      fmt::print("{}: {}\n", expectations_->file, OneLine(breach));
    }
    return check.is_kept();
  }

  static void Refuse(const std::vector<ConfigProblem>& problems) {
    if (!problems.empty()) {
      throw ConfigError(problems);
    }
  }

  int Finish(RunFolder& folder) {
    const ComposedReport report = ComposeReport(records_, scenario_, settings_);
    folder.Write(report.files);
    PrintReport(report.score);
    fmt::print("\nreport: {}\n", OneLine((command_.out / "report.html").string()));
    const bool all_home =
        std::ranges::all_of(outcomes_, [](const auto& o) { return o.ended == "home"; });
    const bool keeps_bounds = KeepsBounds(report.score);
    return all_home && keeps_bounds && !interrupt_requested ? kOk : kFailed;
  }

  void RunOne(RunFolder& folder, const std::string& session, const std::string& former) {
    const SessionPlan plan{.session = session,
                           .mission_folder = command_.mission_folder,
                           .run_folder = command_.out / session,
                           .prior_folder = former.empty() ? fs::path() : command_.out / former,
                           .seed = command_.seed,
                           .delivers_truth_on_board = command_.delivers_truth_on_board};
    const FilledFolder filled(folder.written(), session);
    SessionRecord& record = records_.emplace_back(session);
    SurveyProgress progress(session);
    const SessionOutcome outcome = RunSession(mission_, plan, [&](const Message& message) {
      record.Collect(message);
      if (message.name == topics::kMapCoverage.name || message.name == topics::kSurveyPhase.name) {
        progress.Show(record);
      }
    });
    malloc_trim(0);  // the next session needs it: maps of its own
    // As report.json says it, so that `limpet report` gives the same factor of real time again.
    settings_.wall_s[session] = std::round(1e3 * outcome.wall_s) / 1e3;
    outcomes_.push_back(outcome);
    if (record.ended.empty()) {
      record.ended = outcome.ended;
    }
    if (outcome.cut) {
      record.AddCut(*outcome.cut, outcome.duration);
    }
    progress.Show(record);
  }

  SurveyCommand command_;
  MissionFile mission_;
  Scenario scenario_;
  std::optional<Expectations> expectations_;
  ReportSettings settings_;
  std::vector<SessionRecord> records_;
  std::vector<SessionOutcome> outcomes_;
};

/// Maps of hours are made by several threads, and each thread's own heap would keep what it has
/// freed: a twentieth of what a square kilometre takes, at no cost in time.
void KeepOneHeap() {
  mallopt(M_ARENA_MAX, 1);  // NOLINT(concurrency-mt-unsafe): before any other thread
}

}  // namespace

int RunSurvey(std::span<const std::string> args) {
  return RunCommand(SurveyForm(), args, [](const Arguments& given) {
    KeepOneHeap();
    return SurveyRun(ReadSurveyCommand(given)).Run();
  });
}

}  // namespace limpet
