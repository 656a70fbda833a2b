// SPDX-License-Identifier: MIT
#include "apps/pSafety/safety_app.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/failing_file_system.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

AppContext SafetyContext(TestLink& link) {
  AppContext context;
  context.name = "pSafety";
  context.link = &link;
  return context;
}

class SafetyAppTest : public testing::Test {
 protected:
  void Run(double seconds) {
    for (int i = 0; i < std::lround(5.0 * seconds); ++i) {
      link_.time += Seconds(0.2);
      link_.Send(app_, topics::kNavState, NavState{});
      link_.Send(app_, topics::kHelmState, std::string("DRIVE"));
      link_.Send(app_, topics::kThrusterCommand, ThrusterCommand{});
      link_.Send(app_, topics::kDvlData, dvl_);
      *dvl_.u += 0.001;
      app_.Iterate(link_.time);
    }
  }
  [[nodiscard]] std::string Action() const { return link_.Last(topics::kSafetyAction).value(); }

  TestLink link_;
  SafetyApp app_{SafetyContext(link_), {}};
  DvlSample dvl_ = [] {
    DvlSample sample;
    sample.u = sample.v = sample.w = 0.0;
    return sample;
  }();
};

TEST_F(SafetyAppTest, SaysNoneEverySecondSoThatWhoeverComesKnows) {
  Run(10.0);
  EXPECT_EQ(Action(), "none");
  EXPECT_THAT(link_.Count(topics::kSafetyAction), testing::AllOf(testing::Ge(9), testing::Le(12)));
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(SafetyAppTest, SaysWhatTheTableSaysWarnsAndTellsEveryMargin) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kLeak, true);
  Run(1.6);
  EXPECT_EQ(Action(), "abort");
  EXPECT_TRUE(app_.warnings().contains("TRIPPED_leak"));
  const SafetyState state = link_.Last(topics::kSafetyState).value();
  EXPECT_EQ(state.action, "abort");
  EXPECT_EQ(state.rule, "leak");
  EXPECT_GT(state.since, 0.0);
  ASSERT_EQ(state.rules.size(), kSafetyRules);
  EXPECT_EQ(state.rules[0].rule, "leak");
  EXPECT_DOUBLE_EQ(state.rules[0].margin.value(), -0.5);
  EXPECT_EQ(state.rules[0].stands, "abort");
}

TEST_F(SafetyAppTest, AsksTheMissionManagerForTheWayHomeOnce) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kBattery, BatteryState{.charge = 0.2, .volts = {}, .amperes = {}});
  Run(20.0);
  EXPECT_EQ(Action(), "return");
  EXPECT_EQ(link_.Count(topics::kReturn), 1);
}

TEST_F(SafetyAppTest, AsksForTheWayHomeAlsoOnceAnAbortIsLifted) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kLeak, true);
  Run(2.0);
  ASSERT_EQ(Action(), "abort");
  link_.Send(app_, topics::kShoreBeat, 1.0);
  Run(601.0);
  link_.Send(app_, topics::kLeak, false);
  EXPECT_EQ(link_.Count(topics::kReturn), 0);
  link_.Send(app_, topics::kSafetyReset, true);
  Run(0.2);
  EXPECT_EQ(Action(), "return");  // link_lost
  EXPECT_EQ(link_.Count(topics::kReturn), 1);
}

TEST_F(SafetyAppTest, AnOperatorLiftsWhatStands) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kLeak, true);
  Run(2.0);
  link_.Send(app_, topics::kLeak, false);
  Run(60.0);
  ASSERT_EQ(Action(), "abort");
  link_.Send(app_, topics::kSafetyReset, false);
  Run(1.0);
  ASSERT_EQ(Action(), "abort");
  link_.Send(app_, topics::kSafetyReset, true);
  Run(0.2);
  EXPECT_EQ(Action(), "none");
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(SafetyAppTest, StartedAgainItStandsByWhatItHadSaid) {
  AppContext context = SafetyContext(link_);
  context.is_restarted = true;
  SafetyApp again(context, {});
  SafetyState former;
  former.rules.push_back({.rule = "leak", .margin = {}, .stands = "abort"});
  former.rules.push_back({.rule = "of a newer version", .margin = {}, .stands = "abort"});
  link_.time += Seconds(0.2);
  again.Iterate(link_.time);
  EXPECT_EQ(link_.Count(topics::kSafetyAction), 0);  // `none` would lift it
  former.rules.push_back({.rule = "disk_low", .margin = {}, .stands = "of a newer version"});
  former.rules.push_back({.rule = "disk_full", .margin = {}, .stands = ""});
  link_.SendStamped(again, topics::kSafetyState, former, link_.time - Seconds(5.0));
  link_.time += Seconds(0.2);
  again.Iterate(link_.time);
  EXPECT_EQ(Action(), "abort");
  // Its own words are no former ones, and there was one former life.
  former.rules = {{.rule = "link_lost", .margin = {}, .stands = "return"}};
  link_.SendStamped(again, topics::kSafetyState, former, link_.time - Seconds(5.0));
  link_.time += Seconds(0.2);
  again.Iterate(link_.time);
  EXPECT_FALSE(again.warnings().contains("TRIPPED_link_lost"));
}

TEST_F(SafetyAppTest, StartedAgainItDoesNotTakeItsNewWordsForFormerOnes) {
  AppContext context = SafetyContext(link_);
  context.is_restarted = true;
  SafetyApp again(context, {});
  SafetyState own;
  own.rules.push_back({.rule = "leak", .margin = {}, .stands = "abort"});
  link_.Send(again, topics::kSafetyState, own);
  for (int i = 0; i < 15; ++i) {
    link_.time += Seconds(0.2);
    again.Iterate(link_.time);
  }
  EXPECT_EQ(Action(), "none");
}

TEST_F(SafetyAppTest, StartedAgainWithoutAFormerWordItBeginsAfterAWhile) {
  AppContext context = SafetyContext(link_);
  context.is_restarted = true;
  SafetyApp again(context, {});
  for (int i = 0; i < 15; ++i) {
    link_.time += Seconds(0.2);
    again.Iterate(link_.time);
  }
  EXPECT_EQ(Action(), "none");
}

TEST_F(SafetyAppTest, AMissionMaySetLimitsAndDoWithoutRules) {
  SafetyParams params;
  params.off = {"leak"};
  params.settings.limits[static_cast<std::size_t>(SafetyRuleId::kDepthOverLimit)] = 2.0;
  SafetyApp app(SafetyContext(link_), params);
  link_.Send(app, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app, topics::kLeak, true);
  link_.Send(app, topics::kDepthSensor, 2.5);
  for (int i = 0; i < 15; ++i) {
    link_.time += Seconds(0.2);
    app.Iterate(link_.time);
  }
  EXPECT_EQ(Action(), "surface");
}

TEST_F(SafetyAppTest, RefusesToSwitchOffARuleThatDoesNotExist) {
  SafetyParams params;
  params.off = {"leek"};
  try {
    SafetyApp app(SafetyContext(link_), params);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no safety rule `leek`; nearest known: `leak`"));
  }
}

TEST_F(SafetyAppTest, ShowsAnOperatorEveryRule) {
  link_.Send(app_, topics::kSurveyPhase, std::string("DIVE"));
  link_.Send(app_, topics::kLeak, true);
  Run(2.0);
  ReportLines report;
  app_.Report(report);
  std::string text;
  for (const std::string& line : report.lines()) {
    text += line + "\n";
  }
  EXPECT_THAT(text, HasSubstr("leak: abort"));
  EXPECT_THAT(text, HasSubstr("depth_over_limit"));
}

TEST_F(SafetyAppTest, WarnsOfAPlannerThatTakesTooLongAndLetsGoOnceItIsQuick) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kPlanTime, 4.0);
  Run(1.0);
  EXPECT_EQ(Action(), "none");
  link_.Send(app_, topics::kPlanTime, 6.0);
  Run(1.0);
  EXPECT_EQ(Action(), "warn");
  EXPECT_TRUE(app_.warnings().contains("TRIPPED_planner_slow"));
  link_.Send(app_, topics::kPlanTime, 0.1);
  Run(32.0);
  EXPECT_EQ(Action(), "none");
}

TEST_F(SafetyAppTest, GoesHomeBeforeMemoryIsUsedUp) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kLaunchMemory, 5000.0);
  Run(14.0);
  EXPECT_EQ(Action(), "none");
  Run(2.0);
  EXPECT_EQ(Action(), "return");
}

TEST_F(SafetyAppTest, GoesSlowlyWhileAProcessFillsACore) {
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  link_.Send(app_, topics::kLaunchProcessor, ProcessorLoad{.percent = 99.0, .app = "pMap"});
  Run(14.0);
  EXPECT_EQ(Action(), "none");
  Run(2.0);
  EXPECT_EQ(Action(), "degrade");
  link_.Send(app_, topics::kLaunchProcessor, ProcessorLoad{.percent = 60.0, .app = "pMap"});
  Run(62.0);
  EXPECT_EQ(Action(), "none");
}

TEST_F(SafetyAppTest, MissesASonarThatTheVehiclesFileHas) {
  AppContext context = SafetyContext(link_);
  context.globals = {{.key = "VehicleFile", .value = "feelhippo.yaml", .where = {}}};
  SafetyApp app(context, {});
  link_.Send(app, topics::kSurveyPhase, std::string("SURVEY"));
  for (int i = 0; i < 80; ++i) {
    link_.time += Seconds(0.2);
    app.Iterate(link_.time);
  }
  EXPECT_TRUE(app.warnings().contains("TRIPPED_sonar_silent"));
  EXPECT_FALSE(app_.warnings().contains("TRIPPED_sonar_silent")) << "of no vehicle with one";
}

TEST_F(SafetyAppTest, MissesNoSonarThatTheVehiclesFileHasNot) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "vehicle.yaml")
      << "based_on: feelhippo.yaml\nname: Deaf\nobstacle_sonar: {present: false}\n";
  AppContext context = SafetyContext(link_);
  context.mission_folder = folder.path();
  context.globals = {{.key = "VehicleFile", .value = "vehicle.yaml", .where = {}}};
  SafetyApp app(context, {});
  link_.Send(app, topics::kSurveyPhase, std::string("SURVEY"));
  for (int i = 0; i < 80; ++i) {
    link_.time += Seconds(0.2);
    app.Iterate(link_.time);
  }
  EXPECT_FALSE(app.warnings().contains("TRIPPED_sonar_silent"));
}

TEST_F(SafetyAppTest, WarnsOfADiskThatFillsUp) {
  FailingFileSystem disk(RealFileSystem());
  disk.SetRoom(std::uint64_t{200} << 20U);
  AppContext context = SafetyContext(link_);
  context.disk = &disk;
  SafetyApp app(context, {});
  link_.time += Seconds(0.2);
  app.Iterate(link_.time);
  EXPECT_TRUE(app.warnings().contains("TRIPPED_disk_low"));
  EXPECT_FALSE(app.warnings().contains("TRIPPED_disk_full"));
}

TEST_F(SafetyAppTest, EndsASurveyInAZoneThatIsNarrowerThanTheRegionsLimit) {
  SurveyArea area{.north_min = -20.0, .north_max = 20.0, .east_min = -20.0, .east_max = 20.0};
  link_.Send(app_, topics::kSurveyArea, area);
  link_.Send(app_, topics::kSurveyPhase, std::string("SURVEY"));
  Run(2.0);  // at 0, 0
  EXPECT_EQ(Action(), "none");
  area.keep_out = "{-1,-10:1,-10:1,10:-1,10}";
  link_.Send(app_, topics::kSurveyArea, area);
  Run(2.0);
  EXPECT_EQ(Action(), "return");
  EXPECT_TRUE(app_.warnings().contains("TRIPPED_inside_zone"));
}

}  // namespace
}  // namespace limpet
