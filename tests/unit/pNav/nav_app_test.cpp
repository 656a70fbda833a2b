// SPDX-License-Identifier: MIT
#include "apps/pNav/nav_app.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/test_link.hpp"

namespace limpet {
namespace {

/// A vehicle with ideal sensors that runs east at 0.5 m/s, level, at 1 m depth.
class NavAppTest : public ::testing::Test {
 protected:
  NavAppTest() : app_(MakeContext(), NavApp::Params{}) {}

  AppContext MakeContext() {
    AppContext context;
    context.name = "pNav";
    context.link = &link_;
    return context;
  }
  void RunFor(double seconds, double speed = 0.5) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i, ++step_) {
      link_.time = Seconds(1767225600.0 + 0.02 * step_);
      link_.Send(app_, topics::kFogYawRate, 0.0);
      link_.Send(app_, topics::kImuData, ImuSample{.fz = -9.81, .heading = 0.5 * M_PI});
      east_ += speed * 0.02;
      if (step_ % 10 == 0) {
        link_.Send(app_, topics::kDvlData,
                   DvlSample{.has_lock = true,
                             .u = speed,
                             .v = 0.0,
                             .w = 0.0,
                             .altitude = 4.0,
                             .b1 = 4.4,
                             .b2 = 4.4,
                             .b3 = 4.4,
                             .b4 = 4.4});
        link_.Send(app_, topics::kDepthSensor, 1.0);
      }
      if (has_gps_ && step_ % 50 == 0) {
        link_.Send(app_, topics::kGpsData, GpsFix{.north = 10.0, .east = east_, .sd = 0.4});
      }
      if (step_ % 5 == 0) {
        app_.Tick(link_.time);
      }
    }
  }

  TestLink link_;
  NavApp app_;
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
  link_.Send(app_, topics::kDetections, Detections{.frame = 7, .exposure = exposure, .boxes = {}});
  RunFor(1.0);
  const auto sight = link_.Last(topics::kNavSight);
  ASSERT_TRUE(sight.has_value());
  EXPECT_EQ(sight->frame, 7);
  EXPECT_NEAR(sight->ned[1], east, 0.05);
}

TEST_F(NavAppTest, WarnsWhileTheDvlHasNoLock) {
  RunFor(10.0);
  for (int i = 0; i < 30; ++i) {
    link_.time += Seconds(0.1);
    link_.Send(app_, topics::kDvlData, DvlSample{});
    app_.Tick(link_.time);
  }
  EXPECT_TRUE(app_.warnings().contains("DVL_NO_LOCK"));
  RunFor(1.0);
  EXPECT_FALSE(app_.warnings().contains("DVL_NO_LOCK"));
}

TEST_F(NavAppTest, TellsTheOperatorWhatItWaitsForAndWhereItIs) {
  ReportLines before;
  app_.Report(before);
  EXPECT_THAT(before.Text(), testing::HasSubstr("waiting for heading and a GPS fix"));
  RunFor(10.0);
  ReportLines after;
  app_.Report(after);
  EXPECT_THAT(after.Text(), testing::HasSubstr("GPS fixes:    10, 0 refused"));
  EXPECT_THAT(after.Text(), testing::HasSubstr("DVL pings:    50, 0 without bottom lock"));
  EXPECT_THAT(after.Text(), testing::HasSubstr("Position:     north "));
  EXPECT_THAT(after.Text(), testing::HasSubstr("No landmarks yet."));
}

}  // namespace
}  // namespace limpet
