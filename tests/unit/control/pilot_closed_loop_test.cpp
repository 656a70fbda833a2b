// SPDX-License-Identifier: MIT
// Model, perfect navigation, line of sight and pilot together: what the vehicle really does.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/control/pilot.hpp"
#include "limpet/planning/line_of_sight.hpp"
#include "limpet/vehicle/vehicle_simulation.hpp"

namespace limpet {
namespace {

constexpr double kStep = 0.1;
constexpr double kPi = std::numbers::pi;

/// A vehicle whose navigation is perfect but one control period old, as on board.
class Vessel {
 public:
  explicit Vessel(const Eigen::Vector3d& current_W, const VehicleParams& built = {},
                  const VehicleParams& believed = {})
      : simulation_(VehicleModel(built, current_W, [](const Eigen::Vector2d&) { return 7.5; }), {},
                    IntegratorKind::kRk4),
        pilot_(Pilot::Gains{}, believed),
        nav_(Truth()) {
    pilot_.Reset(nav_);
  }
  [[nodiscard]] NavState Truth() const {
    const VehicleMotion motion = simulation_.motion();
    NavState nav;
    nav.north = motion.X_WB.p_WB.x(), nav.east = motion.X_WB.p_WB.y();
    nav.down = motion.X_WB.p_WB.z();
    nav.roll = motion.X_WB.roll, nav.pitch = motion.X_WB.pitch, nav.yaw = motion.X_WB.yaw;
    nav.u = motion.v_WB_B.x(), nav.v = motion.v_WB_B.y(), nav.w = motion.v_WB_B.z();
    nav.yaw_rate = motion.omega_B.z();
    return nav;
  }
  void Fly(const DesiredMotion& desired) {
    const ThrusterCommand c = pilot_.Update(nav_, desired, kStep);
    nav_ = Truth();
    const auto shares = c.Shares();
    (void)simulation_.Advance(Eigen::Map<const ThrusterVector>(shares.data()), Seconds(kStep));
  }
  /// Flies while the DVL is silent: the estimate holds the last velocity, off by `error` [m/s].
  void FlyWithoutLock(const DesiredMotion& desired, double seconds, const Eigen::Vector2d& error) {
    const NavState held = nav_;
    for (int i = 1; i <= static_cast<int>(seconds / kStep); ++i) {
      nav_.u = held.u + error.x(), nav_.v = held.v + error.y();
      nav_.velocity_age = 0.5 + i * kStep;
      Fly(desired);
    }
  }
  void Hold(const DesiredMotion& desired, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kStep); ++i)
      Fly(desired);
  }

 private:
  VehicleSimulation simulation_;
  Pilot pilot_;
  NavState nav_;
};

struct Track {
  double rms = 0.0, max = 0.0;  ///< cross-track [m]
  double depth_max = 0.0;       ///< depth error [m]
  double sideslip_max = 0.0;    ///< [rad]
};

Track Follow(Vessel& vessel, const std::vector<PathSegment>& segments, double depth) {
  LineOfSight frame;
  const NavState start = vessel.Truth();
  frame.SetPath({start.north, start.east, 0.0}, segments);
  Track track;
  int count = 0;
  for (bool has_arrived = false; !has_arrived; ++count) {
    const NavState nav = vessel.Truth();
    const auto steering = frame.Update({nav.north, nav.east}, std::hypot(nav.u, nav.v));
    vessel.Fly({steering.course, 0.5, depth, steering.turn_rate});
    has_arrived = steering.has_arrived || count > 5000;
    track.rms += steering.cross_track * steering.cross_track;
    track.max = std::max(track.max, std::abs(steering.cross_track));
    track.depth_max = std::max(track.depth_max, std::abs(nav.down - depth));
    if (nav.u > 0.3) {
      track.sideslip_max = std::max(track.sideslip_max, std::abs(std::atan2(nav.v, nav.u)));
    }
  }
  track.rms = std::sqrt(track.rms / count);
  return track;
}

const std::vector<PathSegment> kLaneTurnLane = {
    {0.0, 25.0}, {1.0 / 3.0, 3.0 * kPi}, {0.0, 25.0}, {-1.0 / 3.0, 3.0 * kPi}, {0.0, 25.0}};

class LaneTurnLane : public testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(LaneTurnLane, StaysOnThePathAndAtItsDepth) {
  Vessel vessel(GetParam());
  vessel.Hold({0.0, 0.0, 3.5, 0.0}, 40.0);
  const Track track = Follow(vessel, kLaneTurnLane, 3.5);
  EXPECT_LE(track.rms, 0.10);
  EXPECT_LE(track.max, 0.40);
  EXPECT_LE(track.depth_max, 0.10);
}
INSTANTIATE_TEST_SUITE_P(Currents, LaneTurnLane,
                         testing::Values(Eigen::Vector3d(0.0, 0.0, 0.0),
                                         Eigen::Vector3d(0.1, 0.0, 0.0),
                                         Eigen::Vector3d(0.0, 0.1, 0.0),
                                         Eigen::Vector3d(-0.07, -0.07, 0.0)));

/// The pilot believes VehicleParams{}; the vehicle is built otherwise.
class BuiltOtherwise : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(BuiltOtherwise, StaysNearThePathThoughThePilotDoesNotKnow) {
  const auto [drag, net_buoyancy] = GetParam();
  VehicleParams built;
  built.drag_coefficient *= drag;
  built.net_buoyancy_n = net_buoyancy;
  Vessel vessel({0.0, 0.1, 0.0}, built);
  vessel.Hold({0.0, 0.0, 3.5, 0.0}, 40.0);
  const Track track = Follow(vessel, kLaneTurnLane, 3.5);
  EXPECT_LE(track.rms, 0.15);
  EXPECT_LE(track.depth_max, 0.15);
}
INSTANTIATE_TEST_SUITE_P(DragAndBuoyancy, BuiltOtherwise,
                         testing::Values(std::pair(1.4, 3.0), std::pair(0.6, 3.0),
                                         std::pair(1.0, 8.0)));

TEST(ClosedLoop, FollowsACircleOfThreeMetresWithLittleSideslip) {
  Vessel vessel(Eigen::Vector3d::Zero());
  vessel.Hold({0.0, 0.0, 3.5, 0.0}, 40.0);
  const Track track = Follow(vessel, {{0.0, 5.0}, {1.0 / 3.0, 6.0 * kPi}}, 3.5);
  EXPECT_LT(track.sideslip_max, 5.0 * kPi / 180.0);
  EXPECT_LT(track.max, 0.3);
}

TEST(ClosedLoop, KeepsItsVelocityOverGroundThroughADropoutInACurrent) {
  Vessel vessel(Eigen::Vector3d(-0.05, 0.1, 0.0));
  vessel.Hold({0.0, 0.5, 3.5, 0.0}, 60.0);
  vessel.FlyWithoutLock({0.0, 0.5, 3.5, 0.0}, 10.0, {0.03, -0.03});
  EXPECT_NEAR(vessel.Truth().u, 0.5, 0.02);
  EXPECT_NEAR(vessel.Truth().v, 0.0, 0.02);
}

TEST(ClosedLoop, DivesVerticallyWithoutOvershoot) {
  Vessel vessel(Eigen::Vector3d::Zero());
  double deepest = 0.0;
  for (int i = 0; i < 600; ++i) {
    vessel.Fly({0.8, 0.0, 3.5, 0.0});
    deepest = std::max(deepest, vessel.Truth().down);
  }
  const NavState nav = vessel.Truth();
  EXPECT_LT(deepest, 3.7);
  EXPECT_NEAR(nav.down, 3.5, 0.05);
  EXPECT_NEAR(nav.yaw, 0.8, 0.02);
  EXPECT_LT(std::hypot(nav.north, nav.east), 0.3);
}

/// Of BlueROV2's class: little rights it, and its two vertical thrusters stand side by side.
VehicleParams LightVehicle() {
  VehicleParams light;
  light.mass = 11.5, light.net_buoyancy_n = 2.0;
  light.length_m = 0.457, light.width_m = 0.338;
  light.cg_below_cb_m = 0.02, light.frame_added_mass = 0.2;
  light.drag_coefficient = {0.9, 1.2, 1.2};
  light.thrusters.thrusters[4].p_B = {0.0, 0.111, 0.0};
  light.thrusters.thrusters[5].p_B = {0.0, -0.111, 0.0};
  light.thrusters.max_thrust_n = 22.0;
  return light;
}

TEST(ClosedLoop, ALightVehicleComesDownThoughItIsToGoAheadMeanwhile) {
  Vessel vessel(Eigen::Vector3d::Zero(), LightVehicle(), LightVehicle());
  vessel.Hold({0.0, 0.5, 3.5, 0.0}, 60.0);
  EXPECT_NEAR(vessel.Truth().down, 3.5, 0.2);
  EXPECT_NEAR(vessel.Truth().u, 0.5, 0.1);
  EXPECT_NEAR(vessel.Truth().pitch, 0.0, 0.1);
}

/// As heavy lifters of that class have it: a vertical thruster at each corner.
VehicleParams WithEightThrusters() {
  VehicleParams heavy = LightVehicle();
  heavy.thrusters.thrusters.resize(4);
  for (const double ahead : {0.12, -0.12}) {
    for (const double aside : {0.22, -0.22})
      heavy.thrusters.thrusters.push_back({{ahead, aside, 0.0}, {0.0, 0.0, 1.0}});
  }
  return heavy;
}

TEST(ClosedLoop, EightThrustersFlyAVehicleAndSoDoFive) {
  VehicleParams five;
  five.thrusters.thrusters.pop_back();
  five.thrusters.thrusters.back().p_B.setZero();
  for (const VehicleParams& vehicle : {WithEightThrusters(), five}) {
    Vessel vessel(Eigen::Vector3d::Zero(), vehicle, vehicle);
    vessel.Hold({0.8, 0.4, 3.0, 0.0}, 60.0);
    EXPECT_NEAR(vessel.Truth().down, 3.0, 0.2) << vehicle.thrusters.thrusters.size();
    EXPECT_NEAR(vessel.Truth().u, 0.4, 0.1) << vehicle.thrusters.thrusters.size();
    EXPECT_NEAR(vessel.Truth().yaw, 0.8, 0.05) << vehicle.thrusters.thrusters.size();
  }
}

TEST(ClosedLoop, ComesUpAndFloats) {
  Vessel vessel(Eigen::Vector3d::Zero());
  vessel.Hold({0.0, 0.0, 3.5, 0.0}, 40.0);
  vessel.Hold({0.0, 0.0, 0.0, 0.0}, 30.0);
  EXPECT_LT(vessel.Truth().down, 0.2);
}

TEST(ClosedLoop, TurnsAboutOnTheSpot) {
  Vessel vessel(Eigen::Vector3d::Zero());
  vessel.Hold({0.0, 0.0, 2.0, 0.0}, 30.0);
  vessel.Hold({3.0, 0.0, 2.0, 0.0}, 20.0);
  EXPECT_NEAR(vessel.Truth().yaw, 3.0, 0.02);
  EXPECT_LT(std::hypot(vessel.Truth().north, vessel.Truth().east), 0.3);
}

}  // namespace
}  // namespace limpet
