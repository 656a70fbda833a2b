// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_signs.hpp"

#include <gtest/gtest.h>

#include "tests/unit/safety/safety_signs_fixture.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

TEST_F(SafetySignsTest, CountNoSilenceBeforeTheMissionIsUnderWay) {
  Wait(100.0);
  EXPECT_FALSE(Measure(Id::kNavigationSilent));
  EXPECT_FALSE(Measure(Id::kHelmSilent));
  Enter("ALIGN");
  Wait(3.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kNavigationSilent).value(), 3.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kPilotSilent).value(), 3.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kMissionTime).value(), 3.0);
  Enter("DONE");
  EXPECT_FALSE(Measure(Id::kNavigationSilent));
}

TEST_F(SafetySignsTest, KnowTheEnergyBeyondTheWayHomeAndTheReserve) {
  EXPECT_FALSE(Measure(Id::kEnergyHome));
  signs_.Hear(EnergyState{.left_wh = 100.0, .home_wh = 60.0, .reserve_wh = 50.0});
  EXPECT_DOUBLE_EQ(Measure(Id::kEnergyHome).value(), -10.0);
  EXPECT_FALSE(Measure(Id::kGaugeOff)) << "nobody says a voltage";
  signs_.Hear(EnergyState{.gauge_excess = 0.3});
  EXPECT_DOUBLE_EQ(Measure(Id::kGaugeOff).value(), 30.0);
}

TEST_F(SafetySignsTest, CountTheSilenceOfProcessesInRealTime) {
  SafetySigns fast(10.0);
  fast.HearPhase("SURVEY", now_);
  static_cast<void>(fast.At(now_));
  Wait(20.0);
  EXPECT_DOUBLE_EQ(fast.At(now_)[static_cast<std::size_t>(Id::kHelmSilent)].value(), 2.0);
}

TEST_F(SafetySignsTest, TakeANavigationThatIsNotVouchedForAsSilent) {
  Enter("SURVEY");
  NavState nav = At(0.0, 3.0, 4.0);
  nav.is_valid = false;
  Wait(5.0);
  signs_.Hear(nav, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kNavigationSilent).value(), 5.0);
  EXPECT_FALSE(Measure(Id::kAltitudeLow));
}

TEST_F(SafetySignsTest, NoticeThrustersThatGiveAllTheyHave) {
  signs_.Hear(ThrusterCommand{.t1 = -1.0}, now_);
  Wait(5.0);
  signs_.Hear(ThrusterCommand{.t6 = 1.0}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kThrustersSaturated).value(), 5.0);
  signs_.Hear(ThrusterCommand{.t6 = 0.9}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kThrustersSaturated).value(), 0.0);
}

TEST_F(SafetySignsTest, NoticeAHelmThatDecidesNothingButNotAnOperatorsOverride) {
  Enter("SURVEY");
  signs_.HearHelmState("DRIVE", now_);
  signs_.HearAllStop("NothingToDo", now_);
  Wait(4.0);
  signs_.HearAllStop("MissingNav", now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kHelmIdle).value(), 4.0);
  signs_.HearAllStop("ManualOverride", now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kHelmIdle).value(), 0.0);
  signs_.HearAllStop("NothingToDo", now_);
  signs_.HearAllStop("Safety:hold", now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kHelmIdle).value(), 0.0);
}

TEST_F(SafetySignsTest, RememberThatTheHelmHasSteeredWhenItParks) {
  signs_.HearHelmState("DRIVE", now_);
  signs_.HearAllStop("clear", now_);
  signs_.HearHelmState("PARK", now_);
  signs_.HearAllStop("clear", now_);
  EXPECT_EQ(signs_.phase(), SafetyPhase::kSurvey);
}

TEST_F(SafetySignsTest, TakeAMissionWithoutAManagerForUnderWayOnceItsHelmSteers) {
  EXPECT_EQ(signs_.phase(), SafetyPhase::kIdle);
  signs_.HearHelmState("PARK", now_);
  signs_.HearAllStop("clear", now_);
  EXPECT_EQ(signs_.phase(), SafetyPhase::kIdle);
  signs_.HearHelmState("DRIVE", now_);
  signs_.HearAllStop("clear", now_);
  EXPECT_EQ(signs_.phase(), SafetyPhase::kSurvey);
  signs_.HearPhase("ALIGN", now_);
  EXPECT_EQ(signs_.phase(), SafetyPhase::kAlign);
}

TEST_F(SafetySignsTest, NoticeAnAppThatIsDown) {
  signs_.HearProcesses("app=pNav,state=running # app=pMap,state=waiting", now_);
  Wait(7.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kAppDown).value(), 7.0);
  signs_.HearProcesses("app=pNav,state=given_up", now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kAppDown).value(), 7.0);
  signs_.HearProcesses("app=pNav,state=running", now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kAppDown).value(), 0.0);
}

TEST_F(SafetySignsTest, CountEventsForAWhile) {
  signs_.HearClockSteps(0, now_);
  signs_.HearClockSteps(0, now_);  // said each minute
  EXPECT_DOUBLE_EQ(Measure(Id::kClockStepped).value(), 0.0);
  signs_.HearClockSteps(1, now_);
  signs_.HearBehaviorError(now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kClockStepped).value(), 1.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kBehaviorFailed).value(), 1.0);
  Wait(11.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kClockStepped).value(), 0.0);
}

TEST_F(SafetySignsTest, CountForHowLongTheLogHasNotBeenWritten) {
  EXPECT_FALSE(Measure(Id::kLogFailed)) << "a mission without a log";
  signs_.HearLog(false, now_);
  Wait(2.0);
  signs_.HearLog(false, now_);
  Wait(2.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kLogFailed).value(), 4.0);
  signs_.HearLog(true, now_);
  Wait(2.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kLogFailed).value(), 0.0);
}

TEST_F(SafetySignsTest, PassOnWhatTheVehicleSaysOfItself) {
  EXPECT_FALSE(Measure(Id::kLeak));
  EXPECT_FALSE(Measure(Id::kBatteryLow));
  EXPECT_FALSE(Measure(Id::kLinkLost));
  EXPECT_FALSE(Measure(Id::kDiskLow));
  signs_.HearLeak(true);
  signs_.HearCharge(0.3);
  signs_.HearShore(now_);
  signs_.HearRoom(120.0);
  Wait(2.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kLeak).value(), 1.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kBatteryCritical).value(), 30.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kLinkLost).value(), 2.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDiskFull).value(), 120.0);
}

TEST_F(SafetySignsTest, TakeThePlannersTimeMemoryAndProcessorAsTheyAreSaid) {
  EXPECT_FALSE(Measure(Id::kPlannerSlow)) << "embedded, nobody says it";
  EXPECT_FALSE(Measure(Id::kMemoryHigh));
  EXPECT_FALSE(Measure(Id::kProcessorHigh));
  signs_.HearPlanTime(0.3);
  signs_.HearMemory(800.0);
  signs_.HearProcessor(95.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kPlannerSlow).value(), 0.3);
  EXPECT_DOUBLE_EQ(Measure(Id::kMemoryHigh).value(), 800.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kProcessorHigh).value(), 95.0);
}

}  // namespace
}  // namespace limpet
