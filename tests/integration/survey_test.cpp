// SPDX-License-Identifier: MIT
// One embedded mission end to end: what a user sees of `limpet survey`, on the small basin with
// drawn detections.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "limpet/core/interrupt.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/report/expectation_check.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/scoring/scorer.hpp"
#include "limpet/topics/variable.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

const fs::path kBasin = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";

MissionFile BasinWithBoxes() {
  MissionFile mission = LoadMission(kBasin / "mission.moos");
  ApplySetting(mission, "uSimCamera.camera=boxes");
  return mission;
}

SessionPlan PlanFor(const TemporaryFolder& run, const std::string& session) {
  return {.session = session,
          .mission_folder = kBasin,
          .run_folder = run.path() / session,
          .prior_folder = session == "change" ? run.path() / "discovery" : fs::path(),
          .seed = 3};
}

struct Flight {
  SessionOutcome outcome;
  SessionRecord record;
};

Flight Fly(const SessionPlan& plan) {
  Flight run{.outcome = {}, .record = SessionRecord(plan.session)};
  run.outcome = RunSession(BasinWithBoxes(), plan,
                           [&run](const Message& message) { run.record.Collect(message); });
  return run;
}

/// The log without the lines that only say what the truth was.
std::string OnBoardLog(const fs::path& run_folder, const std::string& session) {
  std::ifstream file(run_folder / (session + ".alog"));
  std::string text;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string time, name;
    words >> time >> name;
    if (!name.starts_with("SIM_")) {
      text += line + "\n";
    }
  }
  return text;
}

/// Apps that wrote a variable which its declaration does not name, `variable by app`. Variables
/// that only a mission or an app's warnings name are nobody's to declare.
std::set<std::string> UndeclaredWrites(const fs::path& run_folder, const std::string& session) {
  std::ifstream file(run_folder / (session + ".alog"));
  std::set<std::string> found;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string time, name, source;
    if (line.starts_with('%') || !(words >> time >> name >> source)) continue;
    source = source.substr(0, source.find(':'));
    const auto variable = VariableCatalog().find(name);
    const bool is_of_mission = source == "pHelm" && !name.starts_with("HELM_");
    if (variable == VariableCatalog().end()) {
      if (!is_of_mission && !name.ends_with("_WARNINGS")) found.insert(name + " by " + source);
    } else if (const std::vector<std::string>& writers = variable->second.facts.writers;
               std::ranges::find(writers, source) == writers.end() &&
               std::ranges::find(writers, "every app") == writers.end()) {
      found.insert(name + " by " + source);
    }
  }
  return found;
}

TEST(Survey, SurveysTwiceComesHomeAndSaysWhatChanged) {
  const TemporaryFolder folder;
  const Scenario scenario = LoadScenario(kBasin / "scenario.yaml");
  const Flight discovery = Fly(PlanFor(folder, "discovery"));
  const Flight change = Fly(PlanFor(folder, "change"));
  ReportSettings settings;
  settings.altitude_m = 3.0;
  settings.object_height_max_m = 1.5;
  settings.object_radius_m = 0.3;
  const RunScore score = ScoreRun({discovery.record, change.record}, scenario, settings);
  const auto expected = LoadExpectations(kBasin, scenario, "");
  ASSERT_TRUE(expected);
  const ExpectationCheck check = CheckReport(*expected, ReportJson(score));
  EXPECT_GT(check.compared, 10);
  EXPECT_THAT(check.breaches, testing::IsEmpty());
  EXPECT_THAT(UndeclaredWrites(folder.path() / "change", "change"), testing::IsEmpty());
}

/// Names with how often they were written.
std::map<std::string, int> WritesByName(const std::string& log) {
  std::istringstream lines(log);
  std::map<std::string, int> writes;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string time, name;
    if (!line.starts_with('%') && words >> time >> name) ++writes[name];
  }
  return writes;
}

TEST(Survey, LeavesInItsLogWhatMoosDisplaysShow) {
  const TemporaryFolder folder;
  static_cast<void>(Fly(PlanFor(folder, "discovery")));
  const std::string log = OnBoardLog(folder.path() / "discovery", "discovery");
  const std::map<std::string, int> writes = WritesByName(log);
  for (const char* name :
       {"APPCAST", "NODE_REPORT_LOCAL", "VIEW_POLYGON", "VIEW_SEGLIST", "VIEW_POINT", "VIEW_MARKER",
        "VIEW_CIRCLE", "IVPHELM_STATE", "IVPHELM_SUMMARY", "IVPHELM_MODESET"}) {
    EXPECT_TRUE(writes.contains(name)) << name;
  }
  EXPECT_EQ(writes.at("APPCAST"), 13);  // each app once, at the end
  EXPECT_NE(log.find("MODE=MODE@ACTIVE:SURVEYING"), std::string::npos);
  // The path and the objects are drawn when they change, not with every tick.
  EXPECT_LT(writes.at("VIEW_SEGLIST"), 200);
  EXPECT_LT(writes.at("VIEW_MARKER"), 200);
}

TEST(Survey, GivesTheSameBitsForTheSameSeed) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  static_cast<void>(Fly(PlanFor(first, "discovery")));
  static_cast<void>(Fly(PlanFor(second, "discovery")));
  const std::string log = OnBoardLog(first.path() / "discovery", "discovery");
  EXPECT_GT(log.size(), 1'000'000U);
  EXPECT_TRUE(log == OnBoardLog(second.path() / "discovery", "discovery"));
}

TEST(Survey, DecidesTheSameWhenTheTruthReachesNobodyOnBoard) {
  const TemporaryFolder with;
  const TemporaryFolder without;
  SessionPlan blind = PlanFor(without, "discovery");
  blind.delivers_truth_on_board = false;
  static_cast<void>(Fly(PlanFor(with, "discovery")));
  static_cast<void>(Fly(blind));
  const std::string log = OnBoardLog(with.path() / "discovery", "discovery");
  EXPECT_GT(log.size(), 1'000'000U);
  EXPECT_TRUE(log == OnBoardLog(without.path() / "discovery", "discovery"));
}

TEST(Survey, AnInterruptEndsItWithTheLogIntact) {
  const TemporaryFolder folder;
  int frames = 0;
  const SessionOutcome outcome =
      RunSession(BasinWithBoxes(), PlanFor(folder, "discovery"), [&frames](const Message& message) {
        frames += message.name == "NAV_CAMERA_FRAME" ? 1 : 0;
        interrupt_requested = frames > 100;
      });
  interrupt_requested = false;
  EXPECT_EQ(outcome.ended, "aborted");
  const std::string log = OnBoardLog(folder.path() / "discovery", "discovery");
  EXPECT_NE(log.find("NAV_CAMERA_FRAME"), std::string::npos);
  EXPECT_TRUE(log.ends_with("\n"));
  EXPECT_TRUE(fs::exists(folder.path() / "discovery" / "session"));
}

TEST(Survey, RefusesADamagedFormerSessionByName) {
  const TemporaryFolder folder;
  static_cast<void>(Fly(PlanFor(folder, "discovery")));
  for (const auto& entry :
       fs::recursive_directory_iterator(folder.path() / "discovery" / "session")) {
    if (entry.path().extension() == ".json") {
      std::ofstream(entry.path(), std::ios::app) << "x";
    }
  }
  EXPECT_THROW(static_cast<void>(Fly(PlanFor(folder, "change"))), ConfigError);
}

}  // namespace
}  // namespace limpet
