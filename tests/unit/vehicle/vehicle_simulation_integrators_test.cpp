// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/vehicle/vehicle_simulation.hpp"

namespace limpet {
namespace {

VehicleSimulation Simulation(IntegratorKind kind, double seabed = 20.0) {
  return {VehicleModel(VehicleParams{}, Eigen::Vector3d(0.05, 0.02, 0.0),
                       [seabed](const Eigen::Vector2d&) { return seabed; }),
          {.north = 0.0, .east = 0.0, .yaw = 0.4},
          kind};
}

/// A lively survey: speed and turns change, depth goes up and down.
ThrusterVector SurveyCommand(double t) {
  ThrusterVector command = ThrusterVector::Zero();
  const double turn = 0.05 * std::sin(0.3 * t);
  const double sink = 0.13 + 0.10 * std::sin(0.05 * t);
  command.head<6>() << 0.4 - turn, 0.4 + turn, 0.4 - turn, 0.4 + turn, sink, sink;
  return command;
}

void Survey(VehicleSimulation& simulation, double duration) {
  for (int i = 0; i < static_cast<int>(duration * 10.0); ++i) {
    (void)simulation.Advance(SurveyCommand(0.1 * i), Seconds(0.1));
  }
}

/// Thrust down, rest, thrust up, float: every event there is.
template <class OnEvent>
void DiveAndAscend(VehicleSimulation& simulation, OnEvent on_event) {
  for (int i = 0; i < 1200; ++i) {
    ThrusterVector command = ThrusterVector::Zero();
    command.segment<2>(4).setConstant(i < 700 ? 0.6 : -0.6);
    command.head<4>().setConstant(0.1);
    for (const TimedEvent& event : simulation.Advance(command, Seconds(0.1)))
      on_event(event);
  }
}

std::vector<TimedEvent> EventsOfADive(IntegratorKind kind) {
  VehicleSimulation simulation = Simulation(kind, 7.5);
  std::vector<TimedEvent> events;
  DiveAndAscend(simulation, [&](const TimedEvent& event) { events.push_back(event); });
  return events;
}

/// Adrift for 20 s while the current grows by 0.1 m/s each second; how far north it has come.
double DriftInAGrowingCurrent(IntegratorKind kind) {
  VehicleSimulation simulation = Simulation(kind);
  for (int i = 0; i < 1000; ++i) {
    simulation.SetCurrent({0.1 * 0.02 * i, 0.0, 0.0});
    (void)simulation.Advance(ThrusterVector::Zero(), Seconds(0.02));
  }
  return simulation.state()(0);
}

TEST(Integrators, NoticeThatTheCurrentGrowsWhileNothingElseChanges) {
  const double rk4 = DriftInAGrowingCurrent(IntegratorKind::kRk4);
  EXPECT_NEAR(rk4, 20.0, 0.5);
  EXPECT_NEAR(DriftInAGrowingCurrent(IntegratorKind::kCvode), rk4, 0.2);
}

TEST(Integrators, AgreeWithinAMillimetreAfterTenMinutes) {
  VehicleSimulation cvode = Simulation(IntegratorKind::kCvode);
  VehicleSimulation rk4 = Simulation(IntegratorKind::kRk4);
  Survey(cvode, 600.0);
  Survey(rk4, 600.0);
  EXPECT_GT(cvode.state().head<2>().norm(), 10.0);
  EXPECT_LT((cvode.state().head<3>() - rk4.state().head<3>()).norm(), 1e-3);
}

TEST(CvodeIntegrator, GivesTheSameBitsForTheSameCommands) {
  VehicleSimulation one = Simulation(IntegratorKind::kCvode);
  VehicleSimulation two = Simulation(IntegratorKind::kCvode);
  Survey(one, 60.0);
  Survey(two, 60.0);
  EXPECT_EQ(one.state(), two.state());
}

TEST(CvodeIntegrator, NeverFailsOnItsWayToTheBottomAndBack) {
  VehicleSimulation simulation = Simulation(IntegratorKind::kCvode, 7.5);
  DiveAndAscend(simulation, [](const TimedEvent&) {});
  EXPECT_EQ(simulation.failures(), 0);
}

TEST(CvodeIntegrator, ReportsSubmergingTouchingLeavingAndSurfacingOnceEach) {
  std::vector<VehicleEvent> kinds;
  for (const TimedEvent& event : EventsOfADive(IntegratorKind::kCvode)) {
    kinds.push_back(event.event);
  }
  EXPECT_EQ(kinds, (std::vector{VehicleEvent::kSubmerged, VehicleEvent::kTouchedBottom,
                                VehicleEvent::kLeftBottom, VehicleEvent::kSurfaced}));
}

TEST(Rk4Integrator, ReportsTheSameEventsAsCvodeWithinAMillisecond) {
  const auto expected = EventsOfADive(IntegratorKind::kCvode);
  const auto found = EventsOfADive(IntegratorKind::kRk4);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].event, expected[i].event);
    EXPECT_NEAR(found[i].since_start.value(), expected[i].since_start.value(), 1e-3);
  }
}

TEST(SeabedContact, LetsTheVehicleRestOnItsSkids) {
  VehicleSimulation simulation = Simulation(IntegratorKind::kCvode, 7.5);
  ThrusterVector down = ThrusterVector::Zero();
  down.segment<2>(4).setConstant(0.6);
  for (int i = 0; i < 900; ++i)
    (void)simulation.Advance(down, Seconds(0.1));
  EXPECT_NEAR(simulation.model().Clearance(simulation.state()), 0.0, 0.01);
  EXPECT_LT(simulation.state().segment<6>(state_index::kVelocity).tail<4>().norm(), 1e-3);
}

TEST(SeabedContact, HoldsOnASlopeWithRelief) {
  const auto seabed = [](const Eigen::Vector2d& p_W) {
    return 4.0 + 0.08 * p_W.x() + 0.05 * std::sin(2.0 * p_W.x()) * std::sin(1.7 * p_W.y());
  };
  VehicleSimulation simulation(
      VehicleModel(VehicleParams{}, Eigen::Vector3d(0.1, 0.0, 0.0), seabed),
      {.north = 0.0, .east = 0.0, .yaw = 1.0}, IntegratorKind::kCvode);
  ThrusterVector down = ThrusterVector::Zero();
  down.segment<2>(4).setConstant(0.8);
  for (int i = 0; i < 600; ++i)
    (void)simulation.Advance(down, Seconds(0.1));
  EXPECT_EQ(simulation.failures(), 0);
  EXPECT_NEAR(simulation.model().Clearance(simulation.state()), 0.0, 0.05);
}

}  // namespace
}  // namespace limpet
