// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_app.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"
#include "tests/unit/pSurvey/survey_app_fixture.hpp"

namespace limpet {
namespace {

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

TEST_F(SurveyAppTest, DivesAsSoonAsItsPlaceIsKnownWellEnough) {
  Nav(-12.0, -15.0, 0.0, 7.5);
  nav_->gps.is_valid = true;
  nav_->sd_north = nav_->sd_east = 0.42;
  link_.Send(app_, topics::kDeploy, true);
  Tick(60.0);
  EXPECT_EQ(Phase(), "ALIGN");
  nav_->sd_north = nav_->sd_east = 0.3;
  Tick(1.0);
  EXPECT_EQ(Phase(), "DIVE");
}

TEST_F(SurveyAppTest, DivesSoonerWhereAFormerSessionsObjectsWillTellThePlace) {
  SurveyApp::Params params = OfTable();
  params.former_fix_target = Meters(0.45);
  for (const std::size_t former : {std::size_t{0}, std::size_t{2}}) {
    TestLink link;
    SurveyApp app(ContextOn(link), params);
    NavState nav{.north = -12.0, .east = -15.0, .altitude = 7.5};
    nav.gps.is_valid = true;
    nav.sd_north = nav.sd_east = 0.42;
    SessionPrior prior;
    prior.former.objects.resize(former);
    link.Send(app, topics::kSessionPrior, prior);
    link.Send(app, topics::kNavState, nav);
    link.Send(app, topics::kDeploy, true);
    app.Tick(link.time);
    link.time += Seconds(60.0);
    link.Send(app, topics::kNavState, nav);
    app.Tick(link.time);
    EXPECT_EQ(link.Last(topics::kSurveyPhase), former == 0 ? "ALIGN" : "DIVE");
  }
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

TEST_F(SurveyAppTest, EndsTheMissionAtTheSurfaceWhenSafetyAsksForThat) {
  ReachSurvey();
  link_.Send(app_, topics::kSafetyAction, std::string("warn"));
  link_.Send(app_, topics::kSafetyAction, std::string("hold"));
  Tick(1.0);
  EXPECT_EQ(Phase(), "SURVEY");
  link_.Send(app_, topics::kSafetyAction, std::string("surface"));
  EXPECT_EQ(Phase(), "ASCEND");
  EXPECT_EQ(link_.Last(topics::kSessionSave), "safety: surface");
  link_.Send(app_, topics::kSafetyAction, std::string("abort"));
  Nav(-12.0, -15.0, 0.1, 7.5);
  Tick(1.0);
  EXPECT_EQ(Phase(), "FIX");
  Tick(SurveyApp::Params{}.last_fix.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "aborted");
}

TEST_F(SurveyAppTest, EndsTheMissionWhereItIsWhenSafetyAsksForTheSurfaceThere) {
  link_.Send(app_, topics::kSafetyAction, std::string("abort"));  // not deployed yet
  Nav(0.0, 0.0, 0.0, 7.5);
  link_.Send(app_, topics::kDeploy, true);
  Tick(1.0);
  EXPECT_EQ(Phase(), "ALIGN");
  link_.Send(app_, topics::kSafetyAction, std::string("abort"));
  EXPECT_EQ(Phase(), "DONE");
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "aborted");
}

TEST_F(SurveyAppTest, IsDoneWhenTheLauncherEndsTheMission) {
  ReachSurvey();
  link_.Send(app_, topics::kMissionEnd, std::string("aborted"));
  EXPECT_EQ(link_.Last(topics::kSurveyPhase), "DONE");
  EXPECT_FALSE(link_.Last(topics::kMissionEnd)) << "it was ended already";
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

TEST_F(SurveyAppTest, WarnsWhileNobodySteers) {
  ReachSurvey();
  const auto hear = [this](const std::string& state, const std::string& all_stop) {
    link_.Send(app_, topics::kHelmAllStop, all_stop);
    link_.Send(app_, topics::kHelmState, state);
    Tick(1.0);
  };
  hear("DRIVE", "clear");
  EXPECT_FALSE(app_.warnings().contains("HELM_INACTIVE"));
  Tick(11.0);
  EXPECT_THAT(app_.warnings().at("HELM_INACTIVE").text, testing::HasSubstr("nothing is heard"));
  hear("DRIVE", "clear");
  EXPECT_FALSE(app_.warnings().contains("HELM_INACTIVE"));
  for (int i = 0; i < 12; ++i) {
    hear("DRIVE", "NothingToDo");
  }
  EXPECT_THAT(app_.warnings().at("HELM_INACTIVE").text, testing::HasSubstr("NothingToDo"));
}

TEST_F(SurveyAppTest, SaysNothingOfTheHelmBeforeItIsDeployed) {
  Tick(100.0);
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(SurveyAppTest, WarnsWhileItCannotNoteTheMissionsState) {
  const TemporaryFolder folder;
  context_.runs_live = true;
  context_.run_folder = folder.path() / "run";
  SurveyApp app(context_, OfTable());
  // A thread writes it; what came of that is told by a later tick.
  const auto warns_within_ticks = [&](bool is_wanted) {
    for (int tick = 0; tick < 1'000'000; ++tick) {
      app.Tick(link_.time);
      if (app.warnings().contains("STATE_NOT_KEPT") == is_wanted) return true;
    }
    return false;
  };
  link_.Send(app, topics::kDeploy, true);
  EXPECT_TRUE(warns_within_ticks(true));
  std::filesystem::create_directory(context_.run_folder);
  link_.time += Seconds(11.0);
  EXPECT_TRUE(warns_within_ticks(false));
}

TEST_F(SurveyAppTest, EndsLostWhenNavigationFallsSilent) {
  ReachSurvey();
  TickWithoutNavigation(SurveyApp::Params{}.lost.value() - 1.0);
  EXPECT_NE(Phase(), "DONE");
  TickWithoutNavigation(2.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "lost");
  EXPECT_TRUE(app_.warnings().contains("NAV_LOST"));
}

TEST_F(SurveyAppTest, GivesUpAWayHomeThatNeverEnds) {
  ReachSurvey();
  link_.Send(app_, topics::kReturn, true);
  Nav(10.0, 10.0, 3.5, 4.0);
  Tick(SurveyApp::Params{}.give_up.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "timeout");
  EXPECT_TRUE(app_.warnings().contains("GAVE_UP"));
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

TEST_F(SurveyAppTest, AShoreWhoseClockIsWrongNeitherEndsNorHurriesTheMission) {
  for (const double off : {-2000.0, 2000.0}) {
    TestLink link;
    SurveyApp app(ContextOn(link), OfTable());
    const NavState nav{.north = -12.0, .east = -15.0, .altitude = 7.5};
    const auto tick = [&](double seconds) {
      link.time += Seconds(seconds);
      link.Send(app, topics::kNavState, nav);
      app.Tick(link.time);
    };
    tick(1.0);
    link.SendStamped(app, topics::kDeploy, true, link.time + Seconds(off));
    tick(SurveyApp::Params{}.align.value() - 1.0);
    EXPECT_EQ(link.Last(topics::kSurveyPhase), "ALIGN") << off;
    tick(2.0);
    EXPECT_EQ(link.Last(topics::kSurveyPhase), "DIVE") << off;
    link.SendStamped(app, topics::kReturn, true, link.time + Seconds(off));
    tick(1.0);
    EXPECT_NE(link.Last(topics::kSurveyPhase), "DONE") << off;
    EXPECT_FALSE(link.Last(topics::kMissionEnd).has_value()) << off;
  }
}

TEST_F(SurveyAppTest, ReturnWhileStillAtTheSurfaceEndsTheMissionThere) {
  Nav(-12.0, -15.0, 0.0, 7.5);
  link_.Send(app_, topics::kDeploy, true);
  Tick(10.0);
  link_.Send(app_, topics::kReturn, true);
  EXPECT_EQ(Phase(), "DONE");
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "aborted");
  Tick(SurveyApp::Params{}.align.value());
  EXPECT_EQ(Phase(), "DONE") << "it must not dive after all";
}

TEST_F(SurveyAppTest, ReturnBeforeDeployHoldsNothingUp) {
  link_.Send(app_, topics::kReturn, true);
  EXPECT_EQ(Phase(), "IDLE");
  ReachSurvey();
  EXPECT_EQ(Phase(), "SURVEY");
}

TEST_F(SurveyAppTest, ReturnOnTheWayHomeChangesNothing) {
  ReachSurvey();
  ReachTarget();
  Tick(1.0);
  ASSERT_EQ(Phase(), "RETURN");
  link_.Send(app_, topics::kReturn, true);
  Nav(-12.0, -15.0, 3.5, 4.0);
  Tick(1.0);
  Nav(-12.0, -15.0, 0.1, 7.4);
  Tick(1.0);
  Tick(SurveyApp::Params{}.last_fix.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "home");
}

TEST_F(SurveyAppTest, EndsLostWhenNavigationIsHeardButNotValid) {
  ReachSurvey();
  nav_->is_valid = false;
  for (double t = 0.0; t < SurveyApp::Params{}.lost.value() + 10.0; t += 10.0) {
    link_.Send(app_, topics::kMapCoverage, Coverage{});
    Tick(10.0);
  }
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "lost");
  EXPECT_TRUE(app_.warnings().contains("NAV_LOST"));
}

}  // namespace
}  // namespace limpet
