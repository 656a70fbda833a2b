// SPDX-License-Identifier: MIT
#include "apps/pNav/nav_app.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/matching/frame_offset.hpp"
#include "limpet/core/frames.hpp"
#include "tests/support/sphere_box.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"
#include "tests/unit/pNav/nav_app_scene.hpp"

namespace limpet {
namespace {

TEST_F(NavAppTest, IsSilentUntilAGpsFixSaysWhereItIs) {
  has_gps_ = false;
  RunFor(20.0);
  EXPECT_FALSE(link_.Last(topics::kNavState).has_value());
}

TEST_F(NavAppTest, WarnsOfADepthSensorThatTellsTheAbsolutePressure) {
  depth_ = 0.1;
  RunFor(30.0);
  EXPECT_FALSE(app_->warnings().contains("DEPTH_NOT_ZEROED"));
  Launch(MakeContext());
  depth_ = 10.2;
  RunFor(30.0);
  EXPECT_TRUE(app_->warnings().contains("DEPTH_NOT_ZEROED"));
}

TEST_F(NavAppTest, FollowsTheVehicleAfterTheFixesEnd) {
  RunFor(20.0);
  has_gps_ = false;
  RunFor(60.0);
  const auto state = link_.Last(topics::kNavState);
  ASSERT_TRUE(state.has_value());
  EXPECT_NEAR(state->north, 10.0, 0.05);
  EXPECT_NEAR(state->east, east_, 0.05);
  EXPECT_NEAR(state->down, 1.0, 0.02);
}

TEST_F(NavAppTest, SpeaksMoosInItsScalars) {
  RunFor(20.0);
  EXPECT_NEAR(*link_.Last(topics::kNavX), east_, 0.05);
  EXPECT_NEAR(*link_.Last(topics::kNavY), 10.0, 0.05);
  EXPECT_NEAR(*link_.Last(topics::kNavHeading), 90.0, 0.1);
  EXPECT_NEAR(*link_.Last(topics::kNavSpeed), 0.5, 1e-3);
}

TEST_F(NavAppTest, SaysTheCurrentOnceASecondAndHowUnsureItIsWithoutATurn) {
  RunFor(30.0);
  const std::size_t before = CountOf("NAV_CURRENT");
  EXPECT_GT(before, 10U);
  RunFor(10.0);
  EXPECT_NEAR(static_cast<double>(CountOf("NAV_CURRENT") - before), 10.0, 1.0);
  const WaterCurrent current = link_.Last(topics::kNavCurrent).value();
  EXPECT_NEAR(current.north, 0.0, 0.03);
  EXPECT_GT(current.sd, 0.05) << "along the way it cannot be told from speed";
  EXPECT_LT(std::abs(current.east), 3.0 * current.sd);
}

TEST_F(NavAppTest, SaysTheAltitudeOfTheBodyAboveTheDvl) {
  RunFor(20.0);
  EXPECT_NEAR(*link_.Last(topics::kNavAltitude), 4.18, 1e-9);
  EXPECT_NEAR(link_.Last(topics::kNavState)->altitude.value(), 4.18, 1e-9);
}

TEST_F(NavAppTest, SendsBeamsFromWhereTheDvlSits) {
  RunFor(20.0);
  const auto state = link_.Last(topics::kNavState);
  const auto beams = link_.Last(topics::kNavBeams);
  ASSERT_TRUE(state && beams);
  EXPECT_NEAR(beams->down - state->down, 0.18, 0.01);
  EXPECT_NEAR(beams->north - state->north, 0.0, 0.01);
  EXPECT_NEAR(beams->east - state->east, -0.2, 0.11);  // aft; pings come at 5 Hz
}

TEST_F(NavAppTest, SendsEchoesOfTheSonarFromWhereItSits) {
  RunFor(20.0);
  const SonarPing ping{.first = -0.5, .step = 0.5, .reach = 15.0, .ranges = {0.0, 7.5, 0.0}};
  link_.Send(*app_, topics::kObstacleSonar, ping);
  const auto state = link_.Last(topics::kNavState);
  const auto sonar = link_.Last(topics::kNavSonar);
  ASSERT_TRUE(state && sonar);
  EXPECT_EQ(sonar->ping.ranges, ping.ranges);
  EXPECT_NEAR(sonar->yaw, state->yaw, 0.01);
  EXPECT_NEAR(sonar->east - state->east, 0.3, 0.11);  // it heads east
}

TEST_F(NavAppTest, MissesASonarThatFallsSilent) {
  RunFor(10.0);
  EXPECT_FALSE(app_->warnings().contains("SONAR_STALE"));
  link_.Send(*app_, topics::kObstacleSonar, SonarPing{.step = 0.1, .reach = 15.0, .ranges = {0.0}});
  RunFor(1.0);
  EXPECT_FALSE(app_->warnings().contains("SONAR_STALE"));
  RunFor(5.0);
  EXPECT_TRUE(app_->warnings().contains("SONAR_STALE"));
}

TEST_F(NavAppTest, PassesOnNoEchoesThatASonarRepeats) {
  RunFor(20.0);
  const SonarPing ping{.first = -0.5, .step = 0.5, .reach = 15.0, .ranges = {0.0, 7.5, 0.0}};
  for (int i = 0; i < 30; ++i) {
    link_.Send(*app_, topics::kObstacleSonar, ping);
    RunFor(0.2);
  }
  EXPECT_EQ(link_.Count(topics::kNavSonar), 1);
  EXPECT_TRUE(app_->warnings().contains("SONAR_STALE")) << "it is as good as silent";
  SonarPing open = ping;
  open.ranges[1] = 0.0;
  link_.Send(*app_, topics::kObstacleSonar, open);
  link_.Send(*app_, topics::kObstacleSonar, open);
  EXPECT_EQ(link_.Count(topics::kNavSonar), 3) << "pings without an echo are all alike";
}

TEST_F(NavAppTest, TellsHowAFixAfterADiveMovesTheWayBehind) {
  RunFor(20.0);
  has_gps_ = false;
  RunFor(60.0);
  link_.published.clear();
  has_gps_ = true;
  east_ += 2.0;  // what dead reckoning had missed
  RunFor(10.0);
  const auto shift = link_.Last(topics::kNavTrackShift);
  ASSERT_TRUE(shift.has_value());
  const double end = shift->steps.back()[0];
  EXPECT_GT(shift->Apply(end - 10.0, Pose{}).p_WB.y(), 0.05);
  EXPECT_DOUBLE_EQ(shift->Apply(end + 1.0, Pose{}).p_WB.y(), 0.0);
  ASSERT_TRUE(shift->SigmaAt(end - 10.0));
  EXPECT_GT(shift->SigmaAt(end - 10.0)->absolute, 0.0) << "and how sure it is now";
}

TEST_F(NavAppTest, PosesAFrameAtItsExposureAlsoWhenItShowsNothing) {
  RunFor(20.0);
  const Seconds exposure = link_.time;
  const double east = east_;
  RunFor(0.25);
  link_.Send(*app_, topics::kDetections, Detections{.frame = 7, .exposure = exposure, .boxes = {}});
  RunFor(1.0);
  const auto frame = link_.Last(topics::kNavCameraFrame);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->frame, 7);
  EXPECT_NEAR(frame->X_WB.p_WB.y(), east, 0.05);
  ASSERT_TRUE(frame->sigma);
  EXPECT_GT(frame->sigma->absolute, 0.0);
  EXPECT_EQ(frame->sigma->beside, 0.0) << "it never was here before";
}

TEST_F(NavAppTest, WarnsOfAFormerSessionWhoseFrameLiesElsewhere) {
  const std::vector<Eigen::Vector3d> objects{{10.5, 32.0, 4.5}, {9.0, 36.0, 4.4},
                                             {11.2, 43.0, 4.5}, {9.4, 46.0, 4.5},
                                             {10.8, 55.0, 4.4}, {9.9, 61.0, 4.5}};
  const FrameOffset off{.shift_W = {12.0, -9.0}, .turn = 0.3};
  SessionPrior prior;
  prior.session = "discovery";
  for (const Eigen::Vector3d& p_W : objects) {
    FormerObject& former = prior.former.objects.emplace_back();
    former.id = static_cast<int>(prior.former.objects.size());
    former.object.p_W = off.Undo(p_W), former.object.color = "yellow";
    former.object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  }
  RunFor(10.0);
  link_.Send(*app_, topics::kSessionPrior, prior);
  RunOver(objects, 95.0);
  EXPECT_TRUE(app_->warnings().contains("FORMER_ELSEWHERE"));
  // Found again where it should be, the warning is over.
  for (std::size_t i = 0; i < objects.size(); ++i)
    prior.former.objects[i].object.p_W = objects[i];
  link_.Send(*app_, topics::kSessionPrior, prior);
  RunFor(5.0);
  EXPECT_FALSE(app_->warnings().contains("FORMER_ELSEWHERE"));
}

TEST_F(NavAppTest, RectifiesTheBoxesOfALensThatDistorts) {
  NavApp::Params params;
  params.camera.distortion = {-0.18, 0.03, 0.0, 0.0, 0.0};
  Launch(MakeContext(), params);
  RunFor(20.0);
  const Box box{.u = 500, .v = 240, .w = 60, .h = 60, .confidence = 0.9, .color = "yellow"};
  const Box corner{.u = 5, .v = 5, .w = 8, .h = 8, .confidence = 0.9, .color = "red"};
  const Seconds exposure = link_.time;
  RunFor(0.25);
  link_.Send(*app_, topics::kDetections,
             Detections{.frame = 7, .exposure = exposure, .boxes = {corner, box}});
  RunFor(1.0);
  const auto frame = link_.Last(topics::kNavCameraFrame);
  ASSERT_TRUE(frame.has_value());
  ASSERT_EQ(frame->boxes.size(), 1U) << "the corner is not in the rectified image";
  const LensModel lens = params.camera.lens();
  const Eigen::Vector2d there = lens.ToPinhole(lens.rectified(), {500.0, 240.0});
  EXPECT_NEAR(frame->boxes[0].u, there.x(), 2.0);
  EXPECT_GT(frame->boxes[0].w, 61.0) << "a barrel makes small what is far from the middle";
}

TEST_F(NavAppTest, WarnsOfAFixThatCannotBe) {
  RunFor(30.0);
  EXPECT_FALSE(app_->warnings().contains("GPS_REFUSED"));
  link_.Send(*app_, topics::kGpsData, GpsFix{.north = 60.0, .east = east_, .sd = 0.4});
  RunFor(2.0);
  EXPECT_TRUE(app_->warnings().contains("GPS_REFUSED"));
  EXPECT_NEAR(link_.Last(topics::kNavState)->north, 10.0, 0.2);
  RunFor(15.0);
  EXPECT_FALSE(app_->warnings().contains("GPS_REFUSED"));
}

TEST_F(NavAppTest, WarnsOfFixesThatWanderFartherThanTheyState) {
  RunFor(40.0);
  EXPECT_FALSE(app_->warnings().contains("GPS_WORSE"));
  const double sure = link_.Last(topics::kNavState)->sd_north;
  for (int i = 0; i < 60; ++i) {
    gps_off_ += (i * 7 % 5 < 3) == (i < 30) ? 0.35 : -0.25;
    RunFor(1.0);
  }
  EXPECT_TRUE(app_->warnings().contains("GPS_WORSE"));
  EXPECT_FALSE(app_->warnings().contains("GPS_REFUSED"));
  EXPECT_GT(link_.Last(topics::kNavState)->sd_north, 2.0 * sure)
      << "nor is the place known so well";
}

TEST_F(NavAppTest, WarnsOfACompassThatSwingsAsTheVehicleTurns) {
  const auto turn_for = [this](double seconds, double swing) {
    for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i, ++step_) {
      constexpr double kRate = 0.1;  // [rad/s]
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      const double yaw = 0.02 * kRate * step_;
      link_.Send(*app_, topics::kFogYawRate, kRate);
      link_.Send(
          *app_, topics::kImuData,
          ImuSample{.fz = -9.81, .r = kRate, .heading = WrapAngle(yaw + swing * std::sin(yaw))});
      if (step_ % 10 == 0) {
        DvlSample ping;
        ping.has_lock = true, ping.u = ping.v = ping.w = 0.0, ping.altitude = 4.0;
        link_.Send(*app_, topics::kDvlData, ping);
        link_.Send(*app_, topics::kDepthSensor, 1.0);
      }
      if (step_ % 50 == 0)
        link_.Send(*app_, topics::kGpsData, GpsFix{.north = 10.0, .east = 20.0, .sd = 0.4});
      if (step_ % 5 == 0) app_->Tick(link_.time);
    }
  };
  turn_for(200.0, 0.002);
  EXPECT_FALSE(app_->warnings().contains("COMPASS_DEVIATES"));
  turn_for(600.0, 0.08);
  EXPECT_TRUE(app_->warnings().contains("COMPASS_DEVIATES"));
}

TEST_F(NavAppTest, WarnsWhileTheDvlHasNoLock) {
  RunFor(10.0);
  for (int i = 0; i < 30; ++i) {
    link_.time += Seconds(0.1);
    link_.Send(*app_, topics::kDvlData, DvlSample{});
    app_->Tick(link_.time);
  }
  EXPECT_TRUE(app_->warnings().contains("DVL_NO_LOCK"));
  RunFor(1.0);
  EXPECT_FALSE(app_->warnings().contains("DVL_NO_LOCK"));
}

TEST_F(NavAppTest, TellsTheOperatorWhatItWaitsForAndWhereItIs) {
  ReportLines before;
  app_->Report(before);
  EXPECT_THAT(before.Text(), testing::HasSubstr("waiting for heading and a GPS fix"));
  RunFor(10.0);
  ReportLines after;
  app_->Report(after);
  EXPECT_THAT(after.Text(), testing::HasSubstr("GPS fixes:    10, 0 refused"));
  EXPECT_THAT(after.Text(), testing::HasSubstr("DVL pings:    50, 0 without bottom lock"));
  EXPECT_THAT(after.Text(), testing::HasSubstr("Position:     north "));
  EXPECT_THAT(after.Text(), testing::HasSubstr("No landmarks yet."));
}

TEST_F(NavAppTest, ShowsTheOperatorTheAgeOfEachSource) {
  RunFor(20.0);
  StayDeaf(60.0);
  ReportLines report;
  app_->Report(report);
  EXPECT_THAT(report.Text(), testing::ContainsRegex("IMU +59.9 +no"));
  EXPECT_THAT(report.Text(), testing::ContainsRegex("camera +never heard +no"));
  EXPECT_THAT(report.Text(), testing::HasSubstr("NOT VALID"));
}

TEST_F(NavAppTest, TurnsTheVelocityOfADvlThatIsMountedTurned) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "vehicle.yaml")
      << "based_on: feelhippo.yaml\nname: Turned\ndvl: {yaw_deg: 180}\n";
  AppContext context = MakeContext();
  context.globals = {{"VehicleFile", "vehicle.yaml", {}}};
  context.mission_folder = folder.path();
  Launch(context);
  RunFor(20.0, -0.5);  // the DVL says astern, and is mounted astern
  EXPECT_NEAR(link_.Last(topics::kNavState)->u, 0.5, 0.01);
}

TEST_F(NavAppTest, IsTheLessSureInSilenceTheFasterTheVehicleIs) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "vehicle.yaml")
      << "based_on: feelhippo.yaml\nname: Fast\nhull: {top_speed_mps: 2.5}\n";
  AppContext context = MakeContext();
  context.globals = {{"VehicleFile", "vehicle.yaml", {}}};
  context.mission_folder = folder.path();
  Launch(context);
  RunFor(20.0);
  StayDeaf(2000.0);
  // 2.5 m/s of vehicle and 0.5 m/s of water, anywhere within reach.
  EXPECT_NEAR(link_.Last(topics::kNavState)->sd_north, 1.5 * 2000.0, 40.0);
}

TEST_F(NavAppTest, IsNotBuiltWithoutAVehicle) {
  AppContext context = MakeContext();
  context.globals.clear();
  EXPECT_THROW(NavApp(context, NavApp::Params{}), ConfigError);
}

}  // namespace
}  // namespace limpet
