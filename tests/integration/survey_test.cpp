// SPDX-License-Identifier: MIT
// One embedded mission end to end: what a user sees of `limpet survey`, on the small basin with
// drawn detections.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "apps/limpet/report/scorer.hpp"
#include "apps/limpet/session_runner.hpp"
#include "limpet/mission/scenario.hpp"
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
    if (line.find(" SIM_") == std::string::npos) {
      text += line + "\n";
    }
  }
  return text;
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
  for (const SessionScore& session : score.sessions) {
    EXPECT_EQ(session.ended, "home");
    EXPECT_LT(session.home_error_m.value_or(99.0), 3.0);
    EXPECT_GT(session.coverage.covered, 0.95);
    EXPECT_GT(session.coverage.detected_band, 0.95);
    EXPECT_THAT(session.opis.missed, testing::IsEmpty());
    EXPECT_THAT(session.opis.invented, testing::IsEmpty());
  }
  for (const ChangeScore& status : score.sessions[1].opis.changes) {
    EXPECT_TRUE(status.is_right())
        << status.truth.value_or("nothing") << " was decided " << status.decided;
  }
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
  int sights = 0;
  const SessionOutcome outcome =
      RunSession(BasinWithBoxes(), PlanFor(folder, "discovery"), [&sights](const Message& message) {
        sights += message.name == "NAV_SIGHT" ? 1 : 0;
        interrupt_requested = sights > 100;
      });
  interrupt_requested = false;
  EXPECT_EQ(outcome.ended, "aborted");
  const std::string log = OnBoardLog(folder.path() / "discovery", "discovery");
  EXPECT_NE(log.find("NAV_SIGHT"), std::string::npos);
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
