// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/survey.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/mission_check.hpp"
#include "apps/limpet/report/expectation_check.hpp"
#include "apps/limpet/report/report.hpp"
#include "apps/limpet/report/report_json.hpp"
#include "apps/limpet/report/survey_progress.hpp"
#include "apps/limpet/report/terminal_report.hpp"
#include "apps/limpet/session_runner.hpp"
#include "apps/limpet/verbs/run_settings.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSurveyHelp =
    R"(usage: limpet survey <mission folder> [options]

Surveys the mission's area once per session (embedded, on virtual time, no port opened),
compares the sessions, and reports what is confirmed, new or removed. Where the mission
has an expect.yaml, the report is held to its bounds: exit code 1 if one is broken.

  --seed N             every random draw comes from it (default 1)
  --out DIR            run folder (default runs/<mission>-<seed>)
  --sessions LIST      sessions of scenario.yaml in order (default discovery,change)
  --set OWNER.KEY=V    override a parameter of an app, or of a behavior by its name
  --planner P          limpet, or paper: the 2025 paper's planner
  --gain G             full, or coverage: objects have no say
  --without-truth      withhold SIM_* from every app on board (the result must not change)
)";

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

SurveyCommand ReadSurveyCommand(std::span<const std::string> args) {
  const Arguments given(args, {"seed", "out", "sessions", "set", "planner", "gain"},
                        {"without-truth", "help"});
  if (given.positionals().size() != 1) {
    throw UsageError("survey takes one mission folder, e.g. missions/table1");
  }
  SurveyCommand command;
  command.mission_folder = fs::path(given.positionals()[0]).lexically_normal();
  if (!command.mission_folder.has_filename()) {
    command.mission_folder = command.mission_folder.parent_path();
  }
  command.mission_name = command.mission_folder.filename().string();
  command.seed = static_cast<std::uint64_t>(given.Integer("seed", 1, 0));
  command.out =
      given.Find("out").value_or(fmt::format("runs/{}-{}", command.mission_name, command.seed));
  command.sessions = Split(given.Find("sessions").value_or("discovery,change"), ',');
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
  for (const std::string& setting : command.settings) {
    command.command_line += " --set " + setting;
  }
  return command;
}

/// A run may replace an earlier run, but nothing else.
void PrepareRunFolder(const fs::path& out) {
  if (fs::exists(out) && !fs::is_empty(out) && !fs::exists(out / "run.json")) {
    throw UsageError(
        fmt::format("{} holds something that is not a run; choose another --out", out.string()));
  }
  for (const char* part : {"figures", "report.json", "report.html", "run.json"}) {
    fs::remove_all(out / part);
  }
  fs::create_directories(out);
}

class SurveyRun {
 public:
  explicit SurveyRun(SurveyCommand command)
      : command_(std::move(command)),
        mission_(LoadMission(command_.mission_folder / "mission.moos")),
        scenario_(LoadScenario(command_.mission_folder / "scenario.yaml")),
        expectations_(LoadExpectations(command_.mission_folder, scenario_)) {
    for (const std::string& setting : command_.settings) {
      ApplySetting(mission_, setting);
    }
    // Everything is checked before the run folder is touched: a slip must not cost an earlier run.
    Refuse(CheckConfiguration(mission_, command_.mission_folder));
    settings_ = SettingsOf(mission_, scenario_);
    settings_.mission = command_.mission_name;
    settings_.seed = command_.seed;
    settings_.command = command_.command_line;
    Refuse(
        CheckGeometry(mission_, scenario_, (command_.mission_folder / "scenario.yaml").string()));
  }

  int Run() {
    PrepareRunFolder(command_.out);
    WriteRunDescription(settings_, scenario_, command_.out);
    for (std::size_t i = 0; i < command_.sessions.size() && !interrupt_requested; ++i) {
      RunOne(command_.sessions[i], FolderOfFormer(i));
    }
    const RunScore score = WriteReport(records_, scenario_, settings_, command_.out);
    PrintReport(score);
    fmt::print("\nreport: {}\n", (command_.out / "report.html").string());
    const bool all_home =
        std::ranges::all_of(outcomes_, [](const auto& o) { return o.ended == "home"; });
    const bool keeps_bounds = KeepsBounds(score);
    return all_home && keeps_bounds && !interrupt_requested ? kOk : kFailed;
  }

 private:
  /// Compares with expect.yaml and says what it breaks.
  [[nodiscard]] bool KeepsBounds(const RunScore& score) const {
    if (!expectations_) return true;
    const ExpectationCheck check = CheckReport(*expectations_, ReportJson(score));
    if (check.is_other_method) {
      fmt::print("expect.yaml is for planner limpet with gain full: not compared\n");
    } else if (check.is_kept()) {
      fmt::print("expect.yaml: all {} bounds are kept\n", check.compared);
    }
    for (const std::string& breach : check.breaches) {
      fmt::print("expect.yaml: {}\n", breach);
    }
    return check.is_kept();
  }

  static void Refuse(const std::vector<ConfigProblem>& problems) {
    if (!problems.empty()) {
      throw ConfigError(problems);
    }
  }

  /// The session before this one in the list; for a change session alone, an earlier run's
  /// discovery.
  [[nodiscard]] fs::path FolderOfFormer(std::size_t i) const {
    if (i > 0) {
      return command_.out / command_.sessions[i - 1];
    }
    const fs::path discovery = command_.out / "discovery";
    return command_.sessions[0] != "discovery" && fs::exists(discovery) ? discovery : fs::path();
  }

  void RunOne(const std::string& session, const fs::path& prior) {
    const SessionPlan plan{.session = session,
                           .mission_folder = command_.mission_folder,
                           .run_folder = command_.out / session,
                           .prior_folder = prior,
                           .seed = command_.seed,
                           .delivers_truth_on_board = command_.delivers_truth_on_board};
    fs::remove_all(plan.run_folder);
    SessionRecord& record = records_.emplace_back(session);
    SurveyProgress progress(session);
    const SessionOutcome outcome = RunSession(mission_, plan, [&](const Message& message) {
      record.Collect(message);
      if (message.name == topics::kMapCoverage.name || message.name == topics::kSurveyPhase.name) {
        progress.Show(record);
      }
    });
    settings_.wall_s[session] = outcome.wall_s;
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

}  // namespace

int RunSurvey(std::span<const std::string> args) {
  if (std::ranges::find(args, "--help") != args.end()) {
    fmt::print("{}", kSurveyHelp);
    return kOk;
  }
  return SurveyRun(ReadSurveyCommand(args)).Run();
}

}  // namespace limpet
