// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/safety/safety_signs.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "tests/unit/safety/safety_signs_fixture.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

TEST_F(SafetySignsTest, TakeTheDeeperOfEstimateAndPressure) {
  signs_.Hear(At(0.0, 3.0, 4.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthOverLimit).value(), 3.0);
  signs_.HearDepth(9.0, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthOverLimit).value(), 9.0);
  signs_.HearDepth(1.0, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthOverLimit).value(), 3.0);
  Wait(10.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthOverLimit).value(), 1.0);
}

TEST_F(SafetySignsTest, MeasureTheRegionOnlyOnceTheSurveyIsInsideIt) {
  signs_.Hear(SurveyArea{.north_min = 0.0, .north_max = 10.0, .east_min = -5.0, .east_max = 5.0});
  Enter("SURVEY");
  signs_.Hear(At(100.0, 3.0, 4.0), now_);
  EXPECT_FALSE(Measure(Id::kOutsideRegion));
  signs_.Hear(At(5.0, 3.0, 4.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
  signs_.Hear(At(17.0, 3.0, 4.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 5.0);
}

TEST_F(SafetySignsTest, CountTheRegionFromTheSurveyOnThoughItWasInsideBefore) {
  const SurveyArea area{.north_min = 0.0, .north_max = 10.0, .east_min = -5.0, .east_max = 5.0};
  signs_.Hear(area);
  signs_.Hear(area);  // said again
  Enter("DIVE");
  signs_.Hear(At(5.0, 3.0, 4.0), now_);
  EXPECT_FALSE(Measure(Id::kOutsideRegion));
  Enter("SURVEY");
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
}

TEST_F(SafetySignsTest, MeasureTheRealShapeOfTheRegion) {
  SurveyArea notched =
      AreaWithin({{0.0, 0.0}, {40.0, 0.0}, {40.0, 10.0}, {10.0, 10.0}, {10.0, 40.0}, {0.0, 40.0}});
  signs_.Hear(notched);
  Enter("SURVEY");
  signs_.Hear(AtPlace(5.0, 5.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
  signs_.Hear(AtPlace(30.0, 22.0), now_);  // within the box around it
  EXPECT_NEAR(Measure(Id::kOutsideRegion).value(), 12.0 - notched.margin, 0.01);
}

TEST_F(SafetySignsTest, MeasureHowFarItIsIntoAZone) {
  SurveyArea area{.north_min = 0.0, .north_max = 40.0, .east_min = 0.0, .east_max = 40.0};
  area.keep_out = "{10,10:30,10:30,30:10,30}";
  signs_.Hear(area);
  Enter("SURVEY");
  signs_.Hear(AtPlace(5.0, 5.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
  signs_.Hear(AtPlace(14.0, 20.0), now_);
  EXPECT_NEAR(Measure(Id::kOutsideRegion).value(), 4.0, 0.01);
}

TEST_F(SafetySignsTest, MeasureHowFarItIsIntoAZoneByTheZonesOwnWidth) {
  SurveyArea area{.north_min = 0.0, .north_max = 40.0, .east_min = 0.0, .east_max = 40.0};
  signs_.Hear(area);
  Enter("SURVEY");
  signs_.Hear(AtPlace(5.0, 5.0), now_);
  EXPECT_FALSE(Measure(Id::kInsideZone)) << "there is none";
  area.keep_out = "{10,10:12,10:12,30:10,30}";
  signs_.Hear(area);
  EXPECT_DOUBLE_EQ(Measure(Id::kInsideZone).value(), 0.0);
  signs_.Hear(AtPlace(20.0, 10.8), now_);
  EXPECT_NEAR(Measure(Id::kInsideZone).value(), 80.0, 1.0);
  EXPECT_NEAR(Measure(Id::kOutsideRegion).value(), 0.8, 0.01);
}

TEST_F(SafetySignsTest, MeasureAZoneOnTheWayInToo) {
  SurveyArea area{.north_min = 0.0, .north_max = 40.0, .east_min = 0.0, .east_max = 40.0};
  area.keep_out = "{60,10:62,10:62,30:60,30}";
  signs_.Hear(area);
  Enter("SURVEY");
  signs_.Hear(AtPlace(20.0, 70.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kInsideZone).value(), 0.0);
  signs_.Hear(AtPlace(20.0, 61.0), now_);
  EXPECT_NEAR(Measure(Id::kInsideZone).value(), 100.0, 1.0);
  EXPECT_FALSE(Measure(Id::kOutsideRegion)) << "it has not been inside yet";
}

TEST_F(SafetySignsTest, KeepTheAreaTheyHaveWhenOneComesThatCannotBe) {
  SurveyArea area{.north_min = 0.0, .north_max = 10.0, .east_min = 0.0, .east_max = 10.0};
  signs_.Hear(area);
  Enter("SURVEY");
  signs_.Hear(AtPlace(5.0, 5.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
  area.north_max = -100.0;
  signs_.Hear(area);
  EXPECT_DOUBLE_EQ(Measure(Id::kOutsideRegion).value(), 0.0);
}

TEST_F(SafetySignsTest, MeasureTheWayHome) {
  signs_.Hear(HomePoint{.north = 3.0, .east = 4.0});
  signs_.Hear(At(0.0, 3.0, 4.0), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kFarFromHome).value(), 5.0);
}

TEST_F(SafetySignsTest, MeasureNoProgressByAnEstimateThatIsOld) {
  signs_.Hear(At(0.0, 3.0, 4.0), now_);
  Wait(10.0);
  signs_.HearWantedSpeed(0.5, now_);
  signs_.HearWantedCourse(0.0);
  EXPECT_FALSE(Measure(Id::kNoProgress));
}

TEST_F(SafetySignsTest, MeasureForHowLongAWantedDepthComesNoNearer) {
  signs_.HearDepth(0.2, now_);
  EXPECT_FALSE(Measure(Id::kNoDepthProgress));
  const auto lie_for = [this](int seconds, bool knows_where) {
    for (int i = 0; i < seconds; ++i) {
      Wait(1.0);
      if (knows_where) signs_.Hear(At(0.0, 0.2, 6.0), now_);
      signs_.HearWantedDepth(6.0, now_);
      signs_.HearDepth(0.2, now_);
    }
  };
  lie_for(11, true);
  EXPECT_DOUBLE_EQ(Measure(Id::kNoDepthProgress).value(), 10.0);
  lie_for(20, false);
  EXPECT_DOUBLE_EQ(Measure(Id::kNoDepthProgress).value(), 0.0)
      << "without navigation nobody steers";
}

TEST_F(SafetySignsTest, MeasureWhatIsMadeGoodOnTheWantedCourse) {
  NavState nav = At(0.0, 3.0, 4.0);
  nav.u = -0.4;
  signs_.Hear(nav, now_);
  EXPECT_FALSE(Measure(Id::kNoProgress));
  signs_.HearWantedSpeed(0.5, now_);
  EXPECT_FALSE(Measure(Id::kNoProgress));
  signs_.HearWantedCourse(0.0);
  EXPECT_NEAR(Measure(Id::kNoProgress).value(), 0.9, 1e-9);
  nav.velocity_age = 3.0;  // held, not measured
  signs_.Hear(nav, now_);
  EXPECT_FALSE(Measure(Id::kNoProgress));
  nav.velocity_age.reset();
  signs_.Hear(nav, now_);
  Wait(10.0);
  EXPECT_FALSE(Measure(Id::kNoProgress));
}

}  // namespace
}  // namespace limpet
