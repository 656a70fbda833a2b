// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/safety/safety_signs.hpp"
#include "tests/unit/safety/safety_signs_fixture.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

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

TEST_F(SafetySignsTest, TellWhatShareOfASensorNavigationRefuses) {
  NavState nav = At(0.0, 3.0, 4.0);
  signs_.Hear(nav, now_);
  EXPECT_FALSE(Measure(Id::kImuOutliers));  // nobody says
  EXPECT_FALSE(Measure(Id::kDvlOutliers));
  nav.imu.refused = 0.07;
  nav.dvl.refused = 0.3;
  signs_.Hear(nav, now_);
  EXPECT_DOUBLE_EQ(Measure(Id::kImuOutliers).value(), 7.0);
  EXPECT_DOUBLE_EQ(Measure(Id::kDvlOutliers).value(), 30.0);
  Wait(5.0);
  EXPECT_FALSE(Measure(Id::kImuOutliers));  // of navigation that is silent
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

}  // namespace
}  // namespace limpet
