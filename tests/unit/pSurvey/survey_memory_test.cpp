// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_memory.hpp"

#include <gtest/gtest.h>

#include "apps/pSurvey/survey_app.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"
#include "tests/unit/pSurvey/survey_app_parts.hpp"

namespace limpet {
namespace {

AppContext LiveContextOn(TestLink& link, const TemporaryFolder& folder) {
  AppContext context = ContextOn(link);
  context.runs_live = true;
  context.run_folder = folder.path();
  return context;
}

TEST(SurveyAppRestart, GoesOnWhereItsFormerLifeWas) {
  const TemporaryFolder folder;
  TestLink link;
  AppContext context = LiveContextOn(link, folder);
  const NavState nav{.north = 3.0, .east = 4.0, .altitude = 7.5};
  {
    SurveyApp former(context, OfTable());
    link.Send(former, topics::kNavState, nav);
    link.Send(former, topics::kDeploy, true);
    link.time += SurveyApp::Params{}.align;
    link.Send(former, topics::kNavState, nav);
    former.Tick(link.time);
    ASSERT_EQ(link.Last(topics::kSurveyPhase), "DIVE");
  }
  link.published.clear();
  context.is_restarted = true;
  SurveyApp next(context, OfTable());
  link.Send(next, topics::kDeploy, true);
  EXPECT_EQ(link.Last(topics::kSurveyPhase), "DIVE");
  EXPECT_DOUBLE_EQ(link.Last(topics::kSurveyHome)->east, 4.0);
  EXPECT_TRUE(link.Last(topics::kSurveyArea).has_value());
}

/// Killed as it ended the mission it may have kept that, and told nobody.
TEST(SurveyAppRestart, SaysAgainHowTheMissionEnded) {
  const TemporaryFolder folder;
  TestLink link;
  AppContext context = LiveContextOn(link, folder);
  {
    SurveyApp former(context, OfTable());
    link.Send(former, topics::kDeploy, true);
    link.Send(former, topics::kSafetyAction, std::string("surface"));
    ASSERT_EQ(link.Last(topics::kMissionEnd), "aborted");
  }
  link.published.clear();
  context.is_restarted = true;
  const SurveyApp next(context, OfTable());
  EXPECT_EQ(link.Last(topics::kSurveyPhase), "DONE");
  EXPECT_EQ(link.Last(topics::kMissionEnd), "aborted");
}

TEST(SurveyAppRestart, TellsPhaseAndAreaAgainForThoseWhoCameBack) {
  const TemporaryFolder folder;
  TestLink link;
  const AppContext context = LiveContextOn(link, folder);
  SurveyApp app(context, OfTable());
  link.Send(app, topics::kDeploy, true);
  link.published.clear();
  link.time += Seconds(11.0);
  app.Tick(link.time);
  EXPECT_EQ(link.Last(topics::kSurveyPhase), "ALIGN");
  EXPECT_TRUE(link.Last(topics::kSurveyArea).has_value());
}

TEST(SurveyAppRestart, WaitsForDeployIfItsFormerLifeDid) {
  const TemporaryFolder folder;
  TestLink link;
  AppContext context = LiveContextOn(link, folder);
  context.is_restarted = true;
  SurveyApp next(context, OfTable());
  EXPECT_FALSE(link.Last(topics::kSurveyPhase).has_value());
  link.Send(next, topics::kDeploy, true);
  EXPECT_EQ(link.Last(topics::kSurveyPhase), "ALIGN");
}

}  // namespace
}  // namespace limpet
