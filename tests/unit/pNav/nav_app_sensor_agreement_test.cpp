// SPDX-License-Identifier: MIT
// Drivers whose signs or units are wrong are told of by name, before objects double.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pNav/nav_app.hpp"
#include "tests/support/test_link.hpp"
#include "tests/unit/pNav/nav_app_scene.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// What drivers make of the truth.
struct Drivers {
  double yaw_rate = 1.0, depth = 1.0, ahead = 1.0, starboard = 1.0;  ///< times what is true
  bool swaps_axes = false;                                           ///< of the DVL
};

/// Circles by its thrusters, going down and up, and says of what it warns.
std::vector<std::string> WarnedOf(const Drivers& drivers) {
  TestLink link;
  AppContext context;
  context.name = "pNav";
  context.link = &link;
  context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
  NavApp app(context, NavApp::Params{});
  for (auto& sensor : UsualSensors())
    app.Hear("usual", std::move(sensor));
  constexpr double kTurn = 0.15, kSpeed = 0.5, kSink = 0.2;
  double yaw = 0.0, depth = 2.0, north = 0.0, east = 0.0;
  for (int i = 0; i < 50 * 150; ++i) {
    link.time = Seconds(1767225600.0 + 0.02 * i);
    const double sink = i / 1500 % 2 == 0 ? kSink : -kSink;
    const double turn = i < 500 ? 0.0 : kTurn;  // it is aligned at rest
    yaw = WrapAngle(yaw + 0.02 * turn);
    depth += 0.02 * sink;
    north += 0.02 * kSpeed * std::cos(yaw), east += 0.02 * kSpeed * std::sin(yaw);
    link.Send(app, topics::kFogYawRate, drivers.yaw_rate * turn);
    link.Send(
        app, topics::kImuData,
        ImuSample{.fy = turn * kSpeed, .fz = -9.81, .r = drivers.yaw_rate * turn, .heading = yaw});
    if (i % 10 == 0) {
      const double u = kSpeed, v = -0.2 * turn;  // the DVL is 0.2 m behind the body's origin
      link.Send(app, topics::kDvlData,
                DvlSample{.has_lock = true,
                          .u = drivers.ahead * (drivers.swaps_axes ? v : u),
                          .v = drivers.starboard * (drivers.swaps_axes ? u : v),
                          .w = sink,
                          .altitude = 4.0,
                          .b1 = 4.4,
                          .b2 = 4.4,
                          .b3 = 4.4,
                          .b4 = 4.4});
      link.Send(app, topics::kDepthSensor, drivers.depth * depth);
      link.Send(app, topics::kThrusterCommand,
                ThrusterCommand{.t1 = 0.25, .t2 = 0.25, .t3 = 0.25, .t4 = 0.25});
    }
    if (i % 50 == 0) {
      link.Send(app, topics::kGpsData, GpsFix{.north = north, .east = east, .sd = 0.4});
    }
    if (i % 5 == 0) app.Tick(link.time);
  }
  std::vector<std::string> motions;
  constexpr std::string_view kFamily = "SENSORS_DISAGREE_";
  for (const auto& [id, warning] : app.warnings()) {
    if (id.starts_with(kFamily)) motions.push_back(id.substr(kFamily.size()));
  }
  return motions;
}

TEST(NavAppSensors, OfASoundVehicleAgree) { EXPECT_THAT(WarnedOf({}), IsEmpty()); }

TEST(NavAppSensors, AGyroThatTurnsTheOtherWayIsNamed) {
  EXPECT_THAT(WarnedOf({.yaw_rate = -1.0}), ElementsAre("TURN"));
}

TEST(NavAppSensors, ADepthThatIsCountedUpwardsIsNamed) {
  EXPECT_THAT(WarnedOf({.depth = -1.0}), ElementsAre("DIVE"));
}

TEST(NavAppSensors, ADvlThatLooksAsternIsNamed) {
  EXPECT_THAT(WarnedOf({.ahead = -1.0, .starboard = -1.0}), ElementsAre("DRIVE"));
}

/// One after another, so that each is alone in its images.
std::vector<Eigen::Vector3d> ObjectsOnTheWay() {
  std::vector<Eigen::Vector3d> objects;
  for (int i = 0; i < 8; ++i)
    objects.emplace_back(10.0 + 0.3 * (i % 3), 26.0 + 7.0 * i, 4.4);
  return objects;
}

TEST_F(NavAppTest, ACameraThatHangsUpsideDownIsNamed) {
  is_camera_upside_down_ = true;
  RunFor(10.0);
  RunOver(ObjectsOnTheWay(), 100.0);
  EXPECT_TRUE(app_->warnings().contains("SENSORS_DISAGREE_SEE"));
}

TEST_F(NavAppTest, ACameraThatHangsAsItsFileSaysIsNot) {
  RunFor(10.0);
  RunOver(ObjectsOnTheWay(), 100.0);
  EXPECT_FALSE(app_->warnings().contains("SENSORS_DISAGREE_SEE"));
  EXPECT_GT(CountOf("NAV_LANDMARKS"), 0U);
}

TEST(NavAppSensors, ADvlWithItsAxesSwappedIsNamed) {
  EXPECT_THAT(WarnedOf({.swaps_axes = true}), ElementsAre("DRIVE"));
}

}  // namespace
}  // namespace limpet
