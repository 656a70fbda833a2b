// SPDX-License-Identifier: MIT
#include "limpet/report/report.hpp"

#include <fstream>
#include <memory>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/report/report_json.hpp"
#include "tests/support/synthetic_session.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string TextOfFile(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<SessionRecord> TwoSessions() {
  std::vector<SessionRecord> records;
  for (const std::string name : {"discovery", "change"}) {
    SyntheticSession session;
    session.name = name;
    session.opis = RightBeliefs(Table1Scenario(), name, 0.3);
    records.push_back(RecordOf(session));
  }
  return records;
}

/// A report of two whole sessions, written once for all tests.
class Report : public testing::Test {
 protected:
  /// Its folder. Not made in SetUpTestSuite: ctest takes what fails there for skipped.
  static fs::path Folder() {
    static const auto folder = [] {
      auto made = std::make_unique<TemporaryFolder>();
      const ComposedReport report =
          ComposeReport(TwoSessions(), Table1Scenario(), Table1Settings());
      fs::create_directories(made->path() / "figures");
      for (const auto& [name, text] : report.files)
        std::ofstream(made->path() / name) << text;
      return made;
    }();
    return folder->path();
  }
  static nlohmann::ordered_json Json() {
    return nlohmann::ordered_json::parse(TextOfFile(Folder() / "report.json"));
  }
  static std::vector<std::string> KeysOf(const nlohmann::ordered_json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items())
      keys.push_back(key);
    return keys;
  }
};

TEST_F(Report, HasTheContractsKeysInItsOrder) {
  EXPECT_THAT(KeysOf(Json()),
              testing::ElementsAre("limpet", "mission", "seed", "settings", "sessions"));
}

TEST_F(Report, HasTheContractsKeysOfADiscoverySession) {
  EXPECT_THAT(KeysOf(Json()["sessions"]["discovery"]),
              testing::ElementsAre(
                  "coverage", "detectable", "covered", "detected_band", "bound", "lanes",
                  "unseen_share", "path_m", "survey_path_m", "options_won", "duration_s", "phase_s",
                  "wall_s", "realtime_factor", "ended", "home_error_m", "outside_region_m",
                  "inside_zone_m", "obstacle_distance_m", "obstacles", "nav", "opis", "missed",
                  "false", "water", "current", "energy", "warnings"));
}

TEST_F(Report, AddsTheKeysOfAChangeSession) {
  const auto change = Json()["sessions"]["change"];
  EXPECT_TRUE(change.contains("prior_opis_seen_path_m") && change.contains("changes"));
}

TEST_F(Report, StatesTheFootprintToTheCentimetre) {
  EXPECT_EQ(Json()["settings"]["footprint_m"].dump(), "[6.71,4.62]");
}

TEST_F(Report, ListsFiveChangesOfTable1) {
  EXPECT_EQ(Json()["sessions"]["change"]["changes"].size(), 5U);
}

TEST_F(Report, ComputesTheRealTimeFactor) {
  const auto session = Json()["sessions"]["discovery"];
  EXPECT_NEAR(session["realtime_factor"].get<double>(), session["duration_s"].get<double>() / 12.5,
              0.01);
}

TEST_F(Report, NeedsNothingFromTheNetwork) {
  const std::string page = TextOfFile(Folder() / "report.html");
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST_F(Report, SaysHowToRunItAgain) {
  EXPECT_THAT(TextOfFile(Folder() / "report.html"),
              HasSubstr("limpet survey missions/table1 --seed 1"));
}

TEST_F(Report, DrawsEveryFigureOfAChangeSession) {
  for (const char* name :
       {"track", "status", "objects", "belief", "coverage", "depth", "navigation"}) {
    EXPECT_TRUE(fs::exists(Folder() / "figures" / (std::string("change_") + name + ".svg")))
        << name;
  }
}

TEST_F(Report, ShowsWhichDecisionsWereForAnObject) {
  const std::string figure = TextOfFile(Folder() / "figures/discovery_track.svg");
  EXPECT_THAT(figure, testing::ContainsRegex("to look at an object: [1-9]"));
  EXPECT_THAT(figure, testing::ContainsRegex("to cover: [1-9]"));
}

TEST_F(Report, ReadsItsOwnDescriptionBack) {
  const RunDescription run = ReadRun(Folder());
  EXPECT_EQ(RunJson(run.settings, run.scenario), RunJson(Table1Settings(), Table1Scenario()));
}

TEST_F(Report, KeepsTheWallTimesOfTheFirstReport) {
  EXPECT_EQ(ReadRun(Folder()).settings.wall_s.at("change"), 14.25);
}

TEST(ReportJson, IsTheSameForTheSameRecords) {
  SyntheticSession session;
  session.seconds_of_survey = 20.0;
  const std::vector<SessionRecord> records{RecordOf(session)};
  EXPECT_EQ(ReportJson(ScoreRun(records, Table1Scenario(), Table1Settings())),
            ReportJson(ScoreRun(records, Table1Scenario(), Table1Settings())));
}

TEST(ReportJson, ListsWarningsWithTheirTimes) {
  SessionScore session;
  session.name = "discovery";
  session.begun = Seconds(1000.0);
  session.warnings = {
      {"pNav", "DVL_STALE", Severity::kWarning, "no bottom lock", Seconds(1010.0), Seconds(1015.5)},
      {"limpet", "SESSION_CUT", Severity::kAlarm, "cut", Seconds(1020.0), {}}};
  RunScore run{Table1Settings(), {session}};
  const auto list = nlohmann::json::parse(ReportJson(run))["sessions"]["discovery"]["warnings"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["app"], "pNav");
  EXPECT_EQ(list[0]["severity"], "warning");
  EXPECT_EQ(list[0]["from_s"], 10.0);
  EXPECT_EQ(list[0]["to_s"], 15.5);
  EXPECT_EQ(list[1]["text"], "cut");
  EXPECT_EQ(list[1]["severity"], "alarm");
  EXPECT_TRUE(list[1]["to_s"].is_null());
}

TEST(ReportJson, SaysNullForALevelNeverReached) {
  SyntheticSession session;
  session.seconds_of_survey = 20.0;
  const RunScore run = ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings());
  const auto json = nlohmann::json::parse(ReportJson(run));
  EXPECT_TRUE(json["sessions"]["discovery"]["coverage"][0]["path_m"].is_null());
}

TEST(ReportJson, SaysWhatLanesTakeAndWhoseOptionsWereFlown) {
  SyntheticSession brief;
  brief.seconds_of_survey = 20.0;
  RunScore run = ScoreRun({RecordOf(brief)}, Table1Scenario(), Table1Settings());
  run.sessions[0].wins = {{.source = "plan", .decisions = 3, .path_m = 9.5}};
  const auto session = nlohmann::json::parse(ReportJson(run))["sessions"]["discovery"];
  EXPECT_GT(session["lanes"]["path_m"].get<double>(), session["bound"]["path_m"].get<double>());
  EXPECT_EQ(session["lanes"]["detectable"][0]["level"], 0.95);
  EXPECT_NEAR(session["survey_path_m"].get<double>(), 10.0, 0.5);
  EXPECT_EQ(session["options_won"]["plan"]["decisions"], 3);
  EXPECT_EQ(session["options_won"]["plan"]["path_m"], 9.5);
}

TEST(ReportJson, SaysTheLowerBoundAndWhyTheRestWasNotSeen) {
  SyntheticSession brief;
  brief.seconds_of_survey = 20.0;
  const RunScore run = ScoreRun({RecordOf(brief)}, Table1Scenario(), Table1Settings());
  const auto session = nlohmann::json::parse(ReportJson(run))["sessions"]["discovery"];
  EXPECT_EQ(session["bound"]["area_m2"], 1080.0);
  EXPECT_NEAR(session["bound"]["path_m"].get<double>(), 321.8, 0.1);
  const auto& unseen = session["unseen_share"];
  EXPECT_NEAR(unseen["band"].get<double>(), 1.0 - session["detected_band"].get<double>(), 1e-9);
  EXPECT_NEAR(unseen["bottom"].get<double>(), 1.0 - session["covered"].get<double>(), 1e-9);
  EXPECT_EQ(unseen["reason"], "not_reached");
  double sum = 0.0;
  for (const auto& share : unseen["band_by_reason"])
    sum += share.get<double>();
  EXPECT_NEAR(sum, unseen["band"].get<double>(), 1e-3);
  EXPECT_EQ(session["phase_s"]["SURVEY"], 20.0);
}

TEST(ReportJson, SaysNullForAWallTimeNobodyTook) {
  ReportSettings settings = Table1Settings();
  settings.wall_s.clear();
  const RunScore run = ScoreRun({SessionRecord("discovery")}, Table1Scenario(), settings);
  EXPECT_TRUE(nlohmann::json::parse(ReportJson(run))["sessions"]["discovery"]["wall_s"].is_null());
}

/// Three sessions, the third as the first: what was removed is back.
std::vector<SessionRecord> ThreeSessions() {
  std::vector<SessionRecord> records;
  for (const std::string name : {"discovery", "change", "third"}) {
    SyntheticSession session;
    session.name = name;
    session.seconds_of_survey = 20.0;
    session.former = name == "discovery" ? "" : name == "change" ? "discovery" : "change";
    session.opis = RightBeliefs(Table1Scenario(), name == "third" ? "change" : name, 0.3);
    records.push_back(RecordOf(session));
  }
  return records;
}

TEST(ThreeSessionReport, HasTheChangesOfEachLaterSession) {
  const ComposedReport report = ComposeReport(ThreeSessions(), Table1Scenario(), Table1Settings());
  const auto sessions = nlohmann::json::parse(report.files.at("report.json")).at("sessions");
  EXPECT_FALSE(sessions.at("discovery").contains("changes"));
  for (const char* name : {"change", "third"}) {
    EXPECT_TRUE(sessions.at(name).contains("changes")) << name;
    EXPECT_TRUE(sessions.at(name).contains("prior_opis_seen_path_m")) << name;
    EXPECT_TRUE(report.files.contains(std::string("figures/") + name + "_status.svg")) << name;
    EXPECT_THAT(report.files.at("report.html"),
                HasSubstr(std::string("id=\"changes-") + name + "\""));
  }
}

/// A change session of a real dive: poses and decisions, and nobody who knows the truth.
ComposedReport ReportWithoutTruth(bool has_scenario) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 60.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  SessionRecord record = RecordOf(session);
  if (has_scenario) record.truth = {};
  ReportSettings settings = Table1Settings();
  settings.has_scenario = has_scenario;
  return ComposeReport({record}, has_scenario ? Table1Scenario() : Scenario{}, settings);
}

TEST(ReportWithoutTruth, LeavesOpenWhatNeedsTheTruth) {
  for (const bool has_scenario : {true, false}) {
    const ComposedReport report = ReportWithoutTruth(has_scenario);
    const auto session =
        nlohmann::json::parse(report.files.at("report.json")).at("sessions").at("change");
    for (const char* key : {"coverage", "detectable", "covered", "detected_band", "path_m",
                            "home_error_m", "missed", "false", "prior_opis_seen_path_m"}) {
      EXPECT_TRUE(session.at(key).is_null()) << key;
    }
    for (const auto& [key, value] : session.at("nav").items())
      EXPECT_TRUE(value.is_null()) << key;
    EXPECT_EQ(session.at("truth"), false);
    EXPECT_EQ(session.at("opis").size(), 3U);
    EXPECT_EQ(session.at("changes").size(), 5U);
  }
}

TEST(ReportWithoutTruth, DrawsWhatTheVehicleKnewAndNothingElse) {
  const ReportFiles files = ReportWithoutTruth(true).files;
  EXPECT_TRUE(files.contains("figures/change_track.svg"));
  EXPECT_TRUE(files.contains("figures/change_belief.svg"));
  EXPECT_FALSE(files.contains("figures/change_navigation.svg"));
  EXPECT_FALSE(files.contains("figures/change_coverage.svg"));
  for (const auto& [name, text] : files) {
    if (!name.ends_with(".svg")) continue;
    EXPECT_THAT(text, Not(HasSubstr("invented"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("wrong"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("true track"))) << name;
  }
  EXPECT_THAT(files.at("report.html"), HasSubstr("There is no truth for this session"));
}

TEST(ReportHtml, EscapesNamesOfTheMission) {
  Scenario scenario = Table1Scenario();
  scenario.opis[0].name = "<script>alert(1)</script>";
  ReportSettings settings = Table1Settings();
  settings.mission = "<b>m";
  const ComposedReport report = ComposeReport(ThreeSessions(), scenario, settings);
  for (const auto& [name, text] : report.files) {
    if (name.ends_with(".json")) continue;
    EXPECT_THAT(text, Not(HasSubstr("<script>"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("<b>m"))) << name;
  }
}

TEST(ReadRun, KeepsHowTheCameraIsTilted) {
  const TemporaryFolder run;
  ReportSettings settings = Table1Settings();
  settings.camera_geometry.R_BC =
      RotationFromRollPitchYaw(0.0, 0.3, 0.0) * CameraModel::LookingDown();
  std::ofstream(run.path() / "run.json") << RunJson(settings, Table1Scenario());
  EXPECT_TRUE(
      ReadRun(run.path()).settings.camera_geometry.R_BC.isApprox(settings.camera_geometry.R_BC));
}

TEST(ReadRun, RefusesASessionsNameThatLeavesTheFolder) {
  const TemporaryFolder run;
  ReportSettings settings = Table1Settings();
  settings.sessions = {"../../x"};
  std::ofstream(run.path() / "run.json") << RunJson(settings, Table1Scenario());
  EXPECT_THROW(static_cast<void>(ReadRun(run.path())), ConfigError);
}

TEST(ReadRun, NamesTheFileThatIsMissing) {
  try {
    (void)ReadRun("/nowhere/at/all");
    FAIL() << "read a run that is not there";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run.json"));
  }
}

}  // namespace
}  // namespace limpet
