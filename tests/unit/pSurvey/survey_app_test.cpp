// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_app.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/test_link.hpp"

namespace limpet {
namespace {

AppContext ContextOn(TestLink& link) {
  AppContext context;
  context.name = "pSurvey";
  context.link = &link;
  return context;
}

class SurveyAppTest : public ::testing::Test {
 protected:
  void Tick(double seconds) {
    link_.time += Seconds(seconds);
    app_.Tick(link_.time);
  }
  void Nav(double north, double east, double down, std::optional<double> altitude) {
    link_.Send(app_, topics::kNavState,
               NavState{.north = north, .east = east, .down = down, .altitude = altitude});
  }
  std::string Phase() { return link_.Last(topics::kSurveyPhase).value_or("IDLE"); }
  void ReachSurvey() {
    Nav(-12.0, -15.0, 0.0, 7.5);
    link_.Send(app_, topics::kDeploy, true);
    Tick(SurveyApp::Params{}.align.value() + 1.0);
    Nav(-12.0, -15.0, 3.5, 4.0);
    Tick(1.0);
  }
  void ReachTarget() { link_.Send(app_, topics::kMapCoverage, Coverage{0.99, 0.99, 0.99}); }

  TestLink link_;
  AppContext context_ = ContextOn(link_);
  SurveyApp app_{context_, {}};
};

TEST_F(SurveyAppTest, WaitsForDeploy) {
  Nav(0.0, 0.0, 0.0, 7.5);
  Tick(100.0);
  EXPECT_EQ(Phase(), "IDLE");
}

TEST_F(SurveyAppTest, TakesTheDivePointAsHome) {
  ReachSurvey();
  EXPECT_EQ(Phase(), "SURVEY");
  EXPECT_DOUBLE_EQ(link_.Last(topics::kSurveyHome)->north, -12.0);
}

TEST_F(SurveyAppTest, GoesHomeWhenTheTargetIsReachedAndNothingIsOpen) {
  ReachSurvey();
  ReachTarget();
  Tick(1.0);
  EXPECT_EQ(Phase(), "RETURN");
}

TEST_F(SurveyAppTest, StaysWhileAnObjectStillWantsALook) {
  ReachSurvey();
  ReachTarget();
  OpiBelief open;
  open.id = 1;
  open.entropy = 0.6;
  link_.Send(app_, topics::kMapOpis, OpiBeliefs{{open}});
  Tick(1.0);
  EXPECT_EQ(Phase(), "SURVEY");
}

TEST_F(SurveyAppTest, GoesHomeShortOfTheTargetWhenCoverageStalls) {
  ReachSurvey();
  Tick(241.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_TRUE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyAppTest, ObeysReturnAndSaysAborted) {
  ReachSurvey();
  link_.Send(app_, topics::kReturn, true);
  EXPECT_EQ(Phase(), "RETURN");
  Nav(-12.0, -15.0, 3.5, 4.0);
  Tick(1.0);
  Nav(-12.0, -15.0, 0.1, 7.4);
  Tick(1.0);
  Tick(SurveyApp::Params{}.last_fix.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "aborted");
}

TEST_F(SurveyAppTest, EndsAtTheSurfaceAtHome) {
  ReachSurvey();
  ReachTarget();
  Tick(1.0);
  Nav(-12.3, -15.2, 3.5, 4.0);
  Tick(1.0);
  EXPECT_EQ(Phase(), "ASCEND");
  Nav(-12.3, -15.2, 0.1, 7.4);
  Tick(1.0);
  EXPECT_EQ(Phase(), "FIX");
  EXPECT_FALSE(link_.Last(topics::kMissionEnd).has_value());
  Tick(SurveyApp::Params{}.last_fix.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "home");
}

TEST(SurveyAppConfiguration, RefusesAnEmptyArea) {
  TestLink link;
  SurveyApp::Params params;
  params.north_max = Meters(-20.0);
  EXPECT_THROW(SurveyApp(ContextOn(link), params), ConfigError);
}

TEST_F(SurveyAppTest, TellsTheOperatorPhaseProgressAndTimeToGo) {
  ReachSurvey();
  link_.Send(app_, topics::kMapCoverage, Coverage{0.5, 0.5, 0.39});
  Tick(100.0);
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Phase:        SURVEY for 100 s"));
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Covered:      39.0 % of 97.5 % (band_top)"));
  EXPECT_THAT(lines.Text(), testing::HasSubstr("about 150 s"));
}

}  // namespace
}  // namespace limpet
