// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_signs.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

class SafetySignsTest : public testing::Test {
 protected:
  [[nodiscard]] std::optional<double> Measure(Id id) {
    return signs_.At(now_)[static_cast<std::size_t>(id)];
  }
  void Wait(double seconds) { now_ += Seconds(seconds); }
  void Enter(const char* phase) {
    signs_.HearPhase(phase, now_);
    static_cast<void>(signs_.At(now_));
  }
  static NavState At(double north, double down, double altitude) {
    NavState nav;
    nav.north = north;
    nav.down = down;
    nav.altitude = altitude;
    return nav;
  }
  static NavState AtPlace(double north, double east) {
    NavState nav = At(north, 3.0, 4.0);
    nav.east = east;
    return nav;
  }
  static DvlSample Velocity(double u) {
    DvlSample dvl;
    dvl.has_lock = true;
    dvl.u = u;
    dvl.v = dvl.w = 0.0;
    dvl.altitude = 4.0;
    return dvl;
  }

  SafetySigns signs_{1.0};
  Seconds now_{1000.0};
};

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

TEST_F(SafetySignsTest, MeasureNoZoneBeforeTheSurveyIsInsideItsRegion) {
  SurveyArea area{.north_min = 0.0, .north_max = 40.0, .east_min = 0.0, .east_max = 40.0};
  area.keep_out = "{10,10:12,10:12,30:10,30}";
  signs_.Hear(area);
  Enter("DIVE");
  signs_.Hear(AtPlace(20.0, 11.0), now_);
  EXPECT_FALSE(Measure(Id::kInsideZone));
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

TEST_F(SafetySignsTest, NoticeASensorThatSaysTheVerySame) {
  for (int i = 0; i < 50; ++i) {
    signs_.Hear(Velocity(0.5), now_);
    signs_.HearDepth(3.0, now_);
    signs_.Hear(ImuSample{}, now_);
    Wait(0.2);
  }
  for (const Id id : {Id::kDvlStuck, Id::kAltitudeStuck, Id::kDepthStuck, Id::kImuStuck}) {
    EXPECT_NEAR(Measure(id).value(), 9.8, 1e-6);
  }
  signs_.Hear(Velocity(0.501), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlStuck).value(), 0.0);
  EXPECT_GT(Measure(Id::kAltitudeStuck).value(), 9.0);
  signs_.Hear(ImuSample{.r = 0.01}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kImuStuck).value(), 0.0);
}

TEST_F(SafetySignsTest, TakeNoSensorThatIsSilentForStuck) {
  signs_.Hear(Velocity(0.5), now_);
  Wait(100.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlStuck).value(), 0.0);
}

TEST_F(SafetySignsTest, MissTheDvlFromTheDiveOn) {
  Enter("ALIGN");
  Wait(200.0);
  EXPECT_FALSE(Measure(Id::kDvlSilent));
  Enter("DIVE");
  Wait(5.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 5.0);
  signs_.Hear(Velocity(0.5), now_);
  signs_.Hear(DvlSample{}, now_);  // no lock: no velocity
  Wait(2.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlLost).value(), 2.0);
}

TEST_F(SafetySignsTest, CountTheDvlFromTheBeginOfADiveThatIsAnnouncedTwice) {
  Enter("DIVE");
  Wait(20.0);
  Enter("DIVE");
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 20.0);
}

TEST_F(SafetySignsTest, TakeAVelocityThatLacksAnAxisForNone) {
  Enter("DIVE");
  Wait(9.0);
  DvlSample dvl = Velocity(0.5);
  dvl.w.reset();
  signs_.Hear(dvl, now_);
  dvl.v.reset();
  signs_.Hear(dvl, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 9.0);
  signs_.Hear(Velocity(0.5), now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 0.0);
}

TEST_F(SafetySignsTest, MissAVelocityThatNavigationDoesNotTake) {
  Enter("DIVE");
  Wait(40.0);
  signs_.Hear(Velocity(0.5), now_);
  NavState nav = At(0.0, 3.0, 4.0);
  nav.velocity_age = 31.0;
  signs_.Hear(nav, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 31.0);
  nav.velocity_age = 300.0;  // from before the dive
  signs_.Hear(nav, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlSilent).value(), 40.0);
}

TEST_F(SafetySignsTest, MissADepthSensorThatHasSpoken) {
  EXPECT_FALSE(Measure(Id::kDepthSilent));
  signs_.HearDepth(3.0, now_);
  Wait(7.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthSilent).value(), 7.0);
}

TEST_F(SafetySignsTest, MissASonarThatNeverSpokeIfTheVehicleHasOne) {
  Enter("ALIGN");
  Wait(20.0);
  EXPECT_FALSE(Measure(Id::kSonarSilent)) << "a vehicle without";
  signs_.ExpectSonar();
  EXPECT_DOUBLE_EQ(Measure(Id::kSonarSilent).value(), 20.0);
  signs_.Hear(SonarPing{.ranges = {4.0}}, now_);
  Wait(12.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kSonarSilent).value(), 12.0);
  Enter("DONE");
  EXPECT_FALSE(Measure(Id::kSonarSilent)) << "not under way";
}

TEST_F(SafetySignsTest, NoticeASonarThatRepeatsItself) {
  EXPECT_FALSE(Measure(Id::kSonarStuck));
  signs_.Hear(SonarPing{.ranges = {4.0}}, now_);
  Wait(12.0);
  signs_.Hear(SonarPing{.ranges = {4.0}}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kSonarStuck).value(), 12.0);
}

TEST_F(SafetySignsTest, NoticeAnAltimeterThatSticksWhileTheVehicleDives) {
  for (int i = 0; i < 100; ++i) {
    signs_.Hear(At(0.0, 0.03 * i, 20.0), now_);
    Wait(0.1);
  }
  EXPECT_GT(Measure(Id::kDepthAgainstAltitude).value(), 2.5);
}

TEST_F(SafetySignsTest, AllowTheGroundASlope) {
  for (int i = 0; i < 200; ++i) {
    signs_.Hear(At(0.05 * i, 3.0, 4.0 + 0.025 * i), now_);
    Wait(0.1);
  }
  EXPECT_DOUBLE_EQ(Measure(Id::kDepthAgainstAltitude).value(), 0.0);
  NavState nav = At(10.0, 3.0, 4.0);
  nav.altitude.reset();
  signs_.Hear(nav, now_);
  EXPECT_FALSE(Measure(Id::kDepthAgainstAltitude));
}

TEST_F(SafetySignsTest, NoticeAJumpOfGpsButNoDrift) {
  const auto fix = [&](double north) {
    signs_.Hear(GpsFix{.north = north, .east = 0.0, .sd = 0.5}, now_);
  };
  EXPECT_FALSE(Measure(Id::kGpsJump));
  fix(0.0);
  Wait(1.0);
  fix(2.5);
  EXPECT_DOUBLE_EQ(Measure(Id::kGpsJump).value(), 0.0);
  Wait(1.0);
  fix(52.5);
  EXPECT_NEAR(Measure(Id::kGpsJump).value(), 50.0 - 2.0 - 3.0 * std::hypot(0.5, 0.5), 1e-9);
}

TEST_F(SafetySignsTest, NoticeAFixAfterADiveFarFromTheEstimate) {
  Enter("DIVE");
  Wait(300.0);
  NavState nav = At(10.0, 0.0, 4.0);
  nav.sd_north = nav.sd_east = 0.4;
  signs_.Hear(nav, now_);
  signs_.Hear(GpsFix{.north = 10.5, .east = 0.0, .sd = 0.3}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kGpsJump).value(), 0.0);
  Wait(300.0);  // two fixes tell nothing any more
  signs_.Hear(nav, now_);
  signs_.Hear(GpsFix{.north = 60.0, .east = 0.0, .sd = 0.3}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kGpsJump).value(), 48.5);
}

TEST_F(SafetySignsTest, CompareAFixAfterADiveWithNoEstimateThatIsOld) {
  Enter("DIVE");
  signs_.Hear(At(10.0, 0.0, 4.0), now_);
  Wait(300.0);
  signs_.Hear(GpsFix{.north = 60.0, .east = 0.0, .sd = 0.3}, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kGpsJump).value(), 0.0);
}

TEST_F(SafetySignsTest, MeasureNoProgressByAnEstimateThatIsOld) {
  signs_.Hear(At(0.0, 3.0, 4.0), now_);
  Wait(10.0);
  signs_.HearWantedSpeed(0.5, now_);
  signs_.HearWantedCourse(0.0);
  EXPECT_FALSE(Measure(Id::kNoProgress));
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

TEST_F(SafetySignsTest, MissNoDetectorAtTheSurface) {
  signs_.HearDetections(Detections{}, now_);
  NavState nav;
  nav.down = 0.2;
  now_ += Seconds(60.0);
  signs_.Hear(nav, now_);
  EXPECT_EQ(Measure(Id::kDetectorLost), 0.0);
  nav.down = 3.5;
  now_ += Seconds(5.0);
  signs_.Hear(nav, now_);
  EXPECT_EQ(Measure(Id::kDetectorLost), 5.0) << "it counts again from there";
}

TEST_F(SafetySignsTest, MissADetectorThatHasSpoken) {
  EXPECT_FALSE(Measure(Id::kDetectorSilent));
  Detections frame;
  frame.boxes.resize(100);
  for (int i = 0; i < 40; ++i) {
    signs_.HearDetections(frame, now_);
  }
  EXPECT_GT(Measure(Id::kDetectorStorm).value(), 80.0);
  Wait(9.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDetectorLost).value(), 9.0);
}

TEST_F(SafetySignsTest, MissACameraThatNeverSpokeFromTheSurveyOn) {
  Enter("DIVE");
  Wait(60.0);
  EXPECT_FALSE(Measure(Id::kDetectorSilent));
  Enter("SURVEY");
  Wait(25.0);
  Enter("SURVEY");  // said again
  EXPECT_DOUBLE_EQ(Measure(Id::kDetectorSilent).value(), 25.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDetectorLost).value(), 25.0);
  EXPECT_FALSE(Measure(Id::kDetectorStorm));
  Enter("RETURN");
  EXPECT_FALSE(Measure(Id::kDetectorSilent));
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
