// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/report.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/report/log_replay.hpp"
#include "apps/limpet/report/report.hpp"
#include "apps/limpet/report/report_json.hpp"
#include "apps/limpet/report/terminal_report.hpp"
#include "apps/limpet/verbs/run_settings.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReportHelp =
    R"(usage: limpet report <run folder> [--mission DIR [--seed N]] [--json]

Scores a run from its logs and writes report.json, figures/ and report.html anew, also for a
run that was cut short. --json prints report.json instead of the table.

A run of `limpet launch` does not say which mission it was: --mission does, e.g.
  limpet report runs/table1-live --mission missions/table1
)";

/// Sessions that left a folder with a log, discovery first, then change, then others by name.
std::vector<std::string> SessionsIn(const fs::path& run) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(run)) {
    if (entry.is_directory() && entry.path().filename() != "figures") {
      names.push_back(entry.path().filename().string());
    }
  }
  const auto rank = [](const std::string& name) {
    return name == "discovery" ? 0 : name == "change" ? 1 : 2;
  };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;
  });
  return names;
}

void DescribeRun(fs::path mission_folder, std::uint64_t seed, const fs::path& run) {
  mission_folder = (mission_folder / "").parent_path();
  const Scenario scenario = LoadScenario(mission_folder / "scenario.yaml");
  ReportSettings settings = SettingsOf(LoadMission(mission_folder / "mission.moos"), scenario);
  settings.mission = mission_folder.filename().string();
  settings.seed = seed;
  settings.command = fmt::format("limpet launch missions/{}/mission.moos", settings.mission);
  WriteRunDescription(settings, scenario, run);
}

}  // namespace

int RunReport(std::span<const std::string> args) {
  const Arguments given(args, {"mission", "seed"}, {"json", "help"});
  if (given.Has("help")) {
    fmt::print("{}", kReportHelp);
    return kOk;
  }
  if (given.positionals().size() != 1)
    throw UsageError("report takes one run folder, e.g. runs/table1-1");
  const fs::path run = given.positionals()[0];
  if (const auto mission = given.Find("mission")) {
    DescribeRun(*mission, static_cast<std::uint64_t>(given.Integer("seed", 1, 0)), run);
  }
  const RunDescription description = ReadRun(run);
  std::vector<SessionRecord> records;
  for (const std::string& session : SessionsIn(run)) {
    auto record = RecordFromLog(run / session);
    if (record) {
      records.push_back(*std::move(record));
    } else {
      fmt::print(stderr, "limpet: {}\n", record.error().text);
    }
  }
  if (records.empty()) {
    fmt::print(stderr, "limpet: {} holds no log of a session\n", run.string());
    return kFailed;
  }
  const RunScore score = WriteReport(records, description.scenario, description.settings, run);
  if (given.Has("json")) {
    fmt::print("{}", ReportJson(score));
  } else {
    PrintReport(score);
    fmt::print("\nreport: {}\n", (run / "report.html").string());
  }
  return kOk;
}

}  // namespace limpet
