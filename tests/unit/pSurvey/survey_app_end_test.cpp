// SPDX-License-Identifier: MIT
// When a survey has seen enough, or will see no more.
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/pSurvey/survey_app_fixture.hpp"

namespace limpet {
namespace {

class SurveyEndTest : public SurveyAppTest {
 protected:
  /// So much of the band's top has been seen, and nearly all below it.
  void Cover(double band_top) {
    link_.Send(app_, topics::kMapCoverage,
               Coverage{.seabed = 0.99, .band = 0.97, .band_top = band_top});
  }
};

TEST_F(SurveyEndTest, GoesHomeWhenTheTargetIsReachedAndNothingIsOpen) {
  ReachSurvey();
  ReachTarget();
  Tick(1.0);
  EXPECT_EQ(Phase(), "RETURN");
}

TEST_F(SurveyEndTest, StaysWhileAnObjectStillWantsALook) {
  ReachSurvey();
  ReachTarget();
  link_.Send(app_, topics::kHelmRevisits, HelmRevisits{{{.id = 1, .state = "open"}}});
  Tick(1.0);
  EXPECT_EQ(Phase(), "SURVEY");
}

TEST_F(SurveyEndTest, DoesNotWaitForAnObjectThatTheHelmHasGivenUp) {
  ReachSurvey();
  ReachTarget();
  link_.Send(app_, topics::kHelmRevisits,
             HelmRevisits{{{.id = 1, .state = "given_up"}, {.id = 2, .state = "out_of_reach"}}});
  Tick(1.0);
  EXPECT_EQ(Phase(), "RETURN");
}

TEST_F(SurveyEndTest, GoesHomeOnceAllCountsAsDoneThoughItClaimsLess) {
  ReachSurvey();
  link_.Send(app_, topics::kMapCoverage,
             Coverage{.seabed = 0.99, .band = 0.97, .band_top = 0.95, .done_band_top = 0.96});
  Tick(1.0);
  EXPECT_EQ(Phase(), "SURVEY");
  link_.Send(app_, topics::kMapCoverage,
             Coverage{.seabed = 0.99, .band = 0.97, .band_top = 0.95, .done_band_top = 0.98});
  Tick(1.0);
  EXPECT_EQ(Phase(), "RETURN");
}

TEST_F(SurveyEndTest, GoesHomeByItsOwnJudgementWhenTheHelmFindsNothingMoreThatIsWorthItsWay) {
  ReachSurvey();
  link_.Send(app_, topics::kHelmGivesUp, true);
  Cover(0.9);
  Tick(11.0);
  EXPECT_EQ(Phase(), "SURVEY") << "too much is lacking";
  Cover(0.97);
  link_.Send(app_, topics::kHelmGivesUp, false);
  link_.Send(app_, topics::kHelmGivesUp, true);
  Tick(9.0);
  EXPECT_EQ(Phase(), "SURVEY") << "it may find something yet";
  Tick(2.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_FALSE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyEndTest, AHelmThatHasGivenUpFliesInVainForFortySecondsAtMost) {
  ReachSurvey();
  link_.Send(app_, topics::kHelmGivesUp, true);
  Cover(0.90);
  Tick(35.0);
  Cover(0.93);
  Tick(35.0);
  EXPECT_EQ(Phase(), "SURVEY") << "it has found something after all";
  Tick(6.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_FALSE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyEndTest, AHelmThatHasGivenUpFarFromTheTargetStalls) {
  ReachSurvey();
  link_.Send(app_, topics::kHelmGivesUp, true);
  link_.Send(app_, topics::kMapCoverage, Coverage{.seabed = 0.9, .band = 0.8, .band_top = 0.7});
  Tick(100.0);
  EXPECT_EQ(Phase(), "SURVEY");
  Tick(141.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_TRUE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyEndTest, GoesHomeShortOfTheTargetWhenCoverageStalls) {
  ReachSurvey();
  Tick(241.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_TRUE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyEndTest, GoesHomeByItsOwnJudgementWhenTheWaterHidesTheRest) {
  ReachSurvey();
  Murk(3.3);  // the band's top is in sight, and seen; the bottom is not
  link_.Send(app_, topics::kMapCoverage, Coverage{0.0, 0.6, 0.99});
  Tick(1.0);
  EXPECT_EQ(Phase(), "RETURN");
}

TEST_F(SurveyEndTest, DoesNotStayWhereNothingIsInSight) {
  ReachSurvey();
  Murk(1.0);
  Tick(100.0);
  EXPECT_EQ(Phase(), "SURVEY");
  Tick(141.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_TRUE(app_.warnings().contains("OUT_OF_SIGHT"));
  EXPECT_FALSE(app_.warnings().contains("COVERAGE_STALLED"));
  Nav(-12.0, -15.0, 3.5, 4.0);
  Tick(1.0);
  Nav(-12.0, -15.0, 0.2, std::nullopt);
  Tick(1.0);
  Tick(1.0);
  Tick(SurveyApp::Params{}.last_fix.value() + 1.0);
  EXPECT_EQ(link_.Last(topics::kMissionEnd), "home");
}

TEST_F(SurveyEndTest, DoesNotStayForTheLittleThatComesIntoSightByChance) {
  ReachSurvey();
  const auto flies = [this](double from, double step) {
    for (int part = 1; part <= 5; ++part) {
      link_.Send(app_, topics::kMapCoverage, Coverage{0.0, 0.0, from + step * part});
      Tick(50.0);
    }
    return Phase();
  };
  EXPECT_EQ(flies(0.0, 0.01), "SURVEY") << "what is planned for may come slowly";
  Murk(1.0);
  EXPECT_EQ(flies(0.05, 0.04), "SURVEY");
  EXPECT_NE(flies(0.25, 0.003), "SURVEY");
  EXPECT_TRUE(app_.warnings().contains("OUT_OF_SIGHT"));
}

TEST_F(SurveyEndTest, CountsWhatComesAfterTheWaterHasTakenCoverageBack) {
  ReachSurvey();
  for (const double share : {0.5, 0.1, 0.2, 0.3, 0.4}) {
    link_.Send(app_, topics::kMapCoverage, Coverage{0.0, 0.0, share});
    Tick(100.0);
    EXPECT_EQ(Phase(), "SURVEY") << share;
  }
}

TEST_F(SurveyEndTest, DoesNotTakeTheWayToTheAreaForAStall) {
  ReachSurvey(-140.0);
  for (double north = -140.0; north < -17.0; north += 10.0) {  // at half a metre per second
    Nav(north, 0.0, 3.5, 4.0);
    Tick(20.0);
    ASSERT_EQ(Phase(), "SURVEY") << "at north " << north;
  }
  EXPECT_FALSE(app_.warnings().contains("TRANSIT_STALLED"));
  Nav(-10.0, 0.0, 3.5, 4.0);
  Tick(1.0);
  Tick(241.0);  // inside, the stall clock runs as ever
  EXPECT_TRUE(app_.warnings().contains("COVERAGE_STALLED"));
}

TEST_F(SurveyEndTest, GoesHomeWhenTheAreaComesNoNearer) {
  ReachSurvey(-140.0);
  Tick(241.0);
  EXPECT_EQ(Phase(), "RETURN");
  EXPECT_TRUE(app_.warnings().contains("TRANSIT_STALLED"));
}

TEST_F(SurveyEndTest, SaysHowFarItIsToTheArea) {
  ReachSurvey(-57.0);
  Tick(1.0);
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Transit:      40 m to the area"));
}

}  // namespace
}  // namespace limpet
