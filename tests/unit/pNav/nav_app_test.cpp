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

namespace limpet {
namespace {

/// A vehicle with ideal sensors that runs east at 0.5 m/s, level, at 1 m depth.
class NavAppTest : public ::testing::Test {
 protected:
  NavAppTest() { app_.emplace(MakeContext(), NavApp::Params{}); }

  AppContext MakeContext() {
    AppContext context;
    context.name = "pNav";
    context.link = &link_;
    context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
    return context;
  }
  void RunFor(double seconds, double speed = 0.5) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i, ++step_) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      link_.Send(*app_, topics::kFogYawRate, 0.0);
      link_.Send(*app_, topics::kImuData, ImuSample{.fz = -9.81, .heading = 0.5 * M_PI});
      east_ += speed * 0.02;
      if (step_ % 10 == 0) {
        link_.Send(*app_, topics::kDvlData,
                   DvlSample{.has_lock = true,
                             .u = speed,
                             .v = 0.0,
                             .w = 0.0,
                             .altitude = 4.0,
                             .b1 = 4.4,
                             .b2 = 4.4,
                             .b3 = 4.4,
                             .b4 = 4.4});
        link_.Send(*app_, topics::kDepthSensor, 1.0);
      }
      if (has_gps_ && step_ % 50 == 0) {
        link_.Send(*app_, topics::kGpsData, GpsFix{.north = 10.0, .east = east_, .sd = 0.4});
      }
      if (step_ % 5 == 0) {
        app_->Tick(link_.time);
      }
    }
  }

  /// Runs on with boxes of what the camera sees of objects of 0.5 m radius, four images a second.
  void RunOver(const std::vector<Eigen::Vector3d>& objects, double seconds) {
    const CameraModel camera = NavApp::Params{}.camera.geometry();
    for (int frame = 0; frame < static_cast<int>(4.0 * seconds); ++frame) {
      RunFor(0.26);
      const Pose X_WB{{10.0, east_ - 0.01, 1.0}, 0.0, 0.0, 0.5 * M_PI};
      Detections seen{.frame = frame, .exposure = link_.time, .boxes = {}};
      for (const Eigen::Vector3d& p_W : objects) {
        auto box = BoxOfSphere(camera.InCamera(X_WB, p_W), 0.5, camera);
        if (!box || box->w < 20.0 || box->h < 20.0) continue;
        box->confidence = 0.9, box->color = "yellow";
        seen.boxes.push_back(*box);
      }
      link_.Send(*app_, topics::kDetections, seen);
    }
  }

  /// Time passes; only pNav's own clock says so.
  void StayDeaf(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 10.0)); ++i, step_ += 5) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      app_->Tick(link_.time);
    }
  }
  std::size_t CountOf(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        link_.published, [&name](const MessagePtr& message) { return message->name == name; }));
  }

  TestLink link_;
  std::optional<NavApp> app_;
  int step_ = 0;
  double east_ = 20.0;
  bool has_gps_ = true;
};

TEST_F(NavAppTest, IsSilentUntilAGpsFixSaysWhereItIs) {
  has_gps_ = false;
  RunFor(20.0);
  EXPECT_FALSE(link_.Last(topics::kNavState).has_value());
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
}

TEST_F(NavAppTest, PosesAFrameAtItsExposureAlsoWhenItShowsNothing) {
  RunFor(20.0);
  const Seconds exposure = link_.time;
  const double east = east_;
  RunFor(0.25);
  link_.Send(*app_, topics::kDetections, Detections{.frame = 7, .exposure = exposure, .boxes = {}});
  RunFor(1.0);
  const auto frame = link_.Last(topics::kNavSight);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->frame, 7);
  EXPECT_NEAR(frame->X_WB.p_WB.y(), east, 0.05);
}

TEST_F(NavAppTest, WarnsOfAFormerSessionWhoseFrameLiesElsewhere) {
  const std::vector<Eigen::Vector3d> objects{{10.5, 32.0, 4.5}, {9.0, 36.0, 4.4},
                                             {11.2, 43.0, 4.5}, {9.4, 46.0, 4.5},
                                             {10.8, 55.0, 4.4}, {9.9, 61.0, 4.5}};
  const FrameOffset off{.shift = {12.0, -9.0}, .turn = 0.3};
  SessionPrior prior;
  prior.session = "discovery";
  for (const Eigen::Vector3d& p_W : objects) {
    FormerObject& former = prior.opis.emplace_back();
    former.id = static_cast<int>(prior.opis.size());
    former.object.p_W = off.Undo(p_W), former.object.color = "yellow";
    former.object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  }
  RunFor(10.0);
  link_.Send(*app_, topics::kSessionPrior, prior);
  RunOver(objects, 95.0);
  EXPECT_TRUE(app_->warnings().contains("FORMER_ELSEWHERE"));
  // Found again where it should be, the warning is over.
  for (std::size_t i = 0; i < objects.size(); ++i)
    prior.opis[i].object.p_W = objects[i];
  link_.Send(*app_, topics::kSessionPrior, prior);
  RunFor(5.0);
  EXPECT_FALSE(app_->warnings().contains("FORMER_ELSEWHERE"));
}

TEST_F(NavAppTest, RectifiesTheBoxesOfALensThatDistorts) {
  NavApp::Params params;
  params.camera.distortion = {-0.18, 0.03, 0.0, 0.0, 0.0};
  app_.emplace(MakeContext(), params);
  RunFor(20.0);
  const Box box{.u = 500, .v = 240, .w = 60, .h = 60, .confidence = 0.9, .color = "yellow"};
  const Box corner{.u = 5, .v = 5, .w = 8, .h = 8, .confidence = 0.9, .color = "red"};
  const Seconds exposure = link_.time;
  RunFor(0.25);
  link_.Send(*app_, topics::kDetections,
             Detections{.frame = 7, .exposure = exposure, .boxes = {corner, box}});
  RunFor(1.0);
  const auto frame = link_.Last(topics::kNavSight);
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
  app_.emplace(context, NavApp::Params{});
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
  app_.emplace(context, NavApp::Params{});
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
