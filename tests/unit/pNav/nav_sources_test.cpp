// SPDX-License-Identifier: MIT
// What pNav says of sensors that fall silent, come back, or lie about the time.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "tests/unit/pNav/nav_app_scene.hpp"

namespace limpet {
namespace {

TEST_F(NavAppTest, SamplesStampedAnHourAheadAreRefusedAndStopNothing) {
  RunFor(20.0);
  const Seconds ahead = link_.time + Seconds(3600.0);
  link_.SendStamped(*app_, topics::kImuData, ImuSample{.fz = -9.81, .r = 1.0, .heading = 0.0},
                    ahead);
  link_.SendStamped(*app_, topics::kFogYawRate, 1.0, ahead);
  DvlSample dvl;
  dvl.has_lock = true;
  dvl.u = 3.0, dvl.v = 0.0, dvl.w = 0.0;
  link_.SendStamped(*app_, topics::kDvlData, dvl, ahead);
  link_.SendStamped(*app_, topics::kDepthSensor, 9.0, ahead);
  link_.SendStamped(*app_, topics::kGpsData, GpsFix{.north = 99.0, .east = 99.0, .sd = 0.4}, ahead);
  link_.Send(*app_, topics::kDetections, Detections{.frame = 1, .exposure = ahead, .boxes = {}});
  for (const char* name :
       {"IMU_DATA", "FOG_YAW_RATE", "DVL_DATA", "DEPTH_SENSOR", "GPS_DATA", "DETECTIONS"}) {
    EXPECT_TRUE(app_->warnings().contains(std::string("STAMP_FROM_FUTURE_") + name)) << name;
  }
  RunFor(30.0);
  const auto state = link_.Last(topics::kNavState);
  EXPECT_NEAR(state->east, east_, 0.05);
  EXPECT_NEAR(state->yaw, 0.5 * M_PI, 0.01);
  EXPECT_TRUE(state->is_usable());
  EXPECT_FALSE(app_->warnings().contains("STAMP_FROM_FUTURE_IMU_DATA"));
}

TEST_F(NavAppTest, SaysTheAgeOfEachSourceAndThatAllAreValid) {
  RunFor(20.0);
  const auto state = link_.Last(topics::kNavState);
  EXPECT_EQ(state->is_valid, true);
  for (const NavSource& source : {state->imu, state->fog, state->dvl, state->depth, state->gps}) {
    EXPECT_EQ(source.is_valid, true);
    EXPECT_LE(source.age.value(), 1.0);
  }
  EXPECT_FALSE(state->camera.age.has_value()) << "there was no frame";
  EXPECT_EQ(state->camera.is_valid, false);
}

TEST_F(NavAppTest, SaysWhatShareOfImuAndDvlItRefusesAndStaysWhereItIs) {
  RunFor(20.0);
  EXPECT_EQ(link_.Last(topics::kNavState)->imu.refused, 0.0);
  EXPECT_EQ(link_.Last(topics::kNavState)->dvl.refused, 0.0);
  for (int i = 0; i < 300; ++i) {  // every sixth inertial sample, every other velocity
    RunFor(0.1);
    const double way = i % 2 == 0 ? 1.0 : -1.0;
    link_.SendStamped(*app_, topics::kImuData,
                      ImuSample{.fy = 30.0 * way, .fz = 9.0, .p = 3.0 * way, .heading = -way},
                      link_.time + Seconds(0.01));
    if (i % 2 == 0) continue;
    DvlSample jump;
    jump.has_lock = true;
    jump.u = 3.0 * std::sin(i), jump.v = 2.0, jump.w = 1.0;
    link_.SendStamped(*app_, topics::kDvlData, jump, link_.time + Seconds(0.01));
  }
  RunFor(0.1);
  const auto state = link_.Last(topics::kNavState);
  EXPECT_NEAR(state->imu.refused.value(), 1.0 / 6.0, 0.05);
  EXPECT_NEAR(state->dvl.refused.value(), 0.5, 0.1);
  EXPECT_NEAR(state->east, east_, 0.05);
  EXPECT_NEAR(state->yaw, 0.5 * M_PI, 0.01);
  EXPECT_NEAR(state->roll, 0.0, 0.005);
  RunFor(40.0);
  EXPECT_LT(link_.Last(topics::kNavState)->imu.refused.value(), 0.001);
  EXPECT_LT(link_.Last(topics::kNavState)->dvl.refused.value(), 0.001);
}

TEST_F(NavAppTest, PublishesNoFrozenEstimateAsFreshWhenAllSensorsFallSilent) {
  RunFor(20.0);
  StayDeaf(3.0);
  link_.published.clear();
  StayDeaf(2040.0);
  EXPECT_EQ(CountOf("NAV_X") + CountOf("NAV_HEADING") + CountOf("NAV_DEPTH"), 0U);
  const auto state = link_.Last(topics::kNavState);
  ASSERT_TRUE(state.has_value());
  EXPECT_FALSE(state->is_usable());
  EXPECT_NEAR(state->imu.age.value(), 2043.0, 0.5);
  EXPECT_NEAR(state->dvl.age.value(), 2043.0, 0.5);
  EXPECT_EQ(state->depth.is_valid, false);
  // 1 m/s of vehicle and 0.5 m/s of water, anywhere within reach.
  EXPECT_NEAR(state->sd_north, 0.75 * 2043.0, 20.0);
  EXPECT_GT(state->sd_down, 100.0);
  EXPECT_GT(state->sd_yaw, 1.5);
  for (const char* id : {"IMU_STALE", "FOG_STALE", "DVL_STALE", "DEPTH_STALE", "NAV_INVALID"}) {
    EXPECT_TRUE(app_->warnings().contains(id)) << id;
  }
}

TEST_F(NavAppTest, EverySensorsWarningIsOverWhenTheSensorIsBack) {
  const auto warned_of = [this] {
    std::vector<std::string> ids;
    for (const char* id :
         {"IMU_STALE", "FOG_STALE", "DVL_STALE", "DVL_NO_LOCK", "DEPTH_STALE", "NAV_INVALID"}) {
      if (app_->warnings().contains(id)) ids.emplace_back(id);
    }
    return ids;
  };
  RunFor(20.0);
  EXPECT_THAT(warned_of(), testing::IsEmpty());
  StayDeaf(30.0);
  EXPECT_EQ(warned_of().size(), 6U);
  RunFor(20.0);
  EXPECT_THAT(warned_of(), testing::IsEmpty());
}

TEST_F(NavAppTest, IsBackWhenItsSensorsAreAndUnsureUntilTheNextFix) {
  RunFor(20.0);
  StayDeaf(300.0);
  has_gps_ = false;
  RunFor(20.0);
  const auto unsure = link_.Last(topics::kNavState);
  EXPECT_TRUE(unsure->is_usable());
  EXPECT_GT(unsure->sd_north, 100.0);
  EXPECT_FALSE(app_->warnings().contains("NAV_INVALID"));
  has_gps_ = true;
  RunFor(20.0);
  const auto sure = link_.Last(topics::kNavState);
  EXPECT_NEAR(sure->east, east_, 1.0);
  EXPECT_LT(sure->sd_north, 2.0);
}

TEST_F(NavAppTest, TheSilenceOfOneSourceIsNamedAndNavigationGoesOn) {
  RunFor(20.0);
  has_gps_ = false;
  for (int i = 0; i < 500; ++i, ++step_) {  // 10 s of attitude and depth alone
    link_.time = Seconds(1767225600.0 + 0.02 * step_);
    link_.Send(*app_, topics::kFogYawRate, 0.0);
    link_.Send(*app_, topics::kImuData, ImuSample{.fz = -9.81, .heading = 0.5 * M_PI});
    if (step_ % 10 == 0) link_.Send(*app_, topics::kDepthSensor, 1.0);
    if (step_ % 5 == 0) app_->Tick(link_.time);
  }
  const auto state = link_.Last(topics::kNavState);
  EXPECT_TRUE(state->is_usable());
  EXPECT_EQ(state->dvl.is_valid, false);
  EXPECT_EQ(state->gps.is_valid, false);
  EXPECT_EQ(state->depth.is_valid, true);
  EXPECT_TRUE(app_->warnings().contains("DVL_STALE"));
}

TEST_F(NavAppTest, WarnsOfWhatBoxesShowAgainAndAgainWithoutAPlace) {
  RunFor(20.0);
  // A wall that no image holds, along the port side.
  const Box wall{.u = 110, .v = 240, .w = 220, .h = 480, .confidence = 0.9, .color = "yellow"};
  for (int frame = 0; frame < 20; ++frame) {
    RunFor(0.26);
    link_.Send(*app_, topics::kDetections,
               Detections{.frame = frame, .exposure = link_.time, .boxes = {wall}});
  }
  RunFor(2.0);
  EXPECT_TRUE(app_->warnings().contains("OBJECTS_UNPLACED"));
}

TEST_F(NavAppTest, OfWhatStandsInItsPlaceNothingIsUnplaced) {
  RunFor(20.0);
  RunOver({{10.5, east_ + 2.5, 4.0}}, 7.0);
  RunFor(25.0);
  EXPECT_EQ(link_.Last(topics::kNavLandmarks)->landmarks.size(), 1U);
  EXPECT_FALSE(app_->warnings().contains("OBJECTS_UNPLACED"));
}

TEST_F(NavAppTest, AnImuWhoseClockWasSetBackCostsNoHeading) {
  RunFor(20.0);
  double yaw = 0.5 * M_PI;
  const double rate = 0.38;  // [rad/s] 22 degrees in the second that is missed
  for (int i = 0; i < 1000; ++i, ++step_) {
    link_.time = Seconds(1767225600.0 + 0.02 * step_);
    yaw += rate * 0.02;
    const Seconds stamp = link_.time - Seconds(i < 250 ? 0.0 : 1.0);
    link_.SendStamped(*app_, topics::kFogYawRate, rate, stamp);
    link_.SendStamped(*app_, topics::kImuData,
                      ImuSample{.fz = -9.81, .r = rate, .heading = WrapAngle(yaw)}, stamp);
    if (step_ % 10 == 0) link_.Send(*app_, topics::kDepthSensor, 1.0);
    if (step_ % 5 == 0) app_->Tick(link_.time);
  }
  // Its samples are taken for a second older than they are; the estimate leads them by 0.3 s.
  const auto state = link_.Last(topics::kNavState);
  EXPECT_LT(std::abs(WrapAngle(state->yaw - (yaw + 0.3 * rate))), 0.05);
  ReportLines report;
  app_->Report(report);
  EXPECT_THAT(report.Text(), testing::HasSubstr("Out of order: 50 of the IMU"));
}

}  // namespace
}  // namespace limpet
