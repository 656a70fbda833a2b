// SPDX-License-Identifier: MIT
// CPU cost of the simulator, as times real time: the model under either integrator, and uSimVehicle
// and uSimSensors as apps of an embedded community.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

#include "limpet/app/embedded.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/vehicle/vehicle_simulation.hpp"

namespace limpet {
namespace {

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs `work`, which simulates `simulated` seconds, and prints what it cost.
void Measure(const char* what, double simulated, const std::function<void()>& work) {
  const double begin = CpuSeconds();
  work();
  const double cost = CpuSeconds() - begin;
  std::printf("%-34s %8.3f ms per simulated second, %8.0f x real time\n", what,
              1000.0 * cost / simulated, simulated / cost);
}

ThrusterCommand SurveyCommand(double t) {
  const double turn = 0.05 * std::sin(0.3 * t);
  return {.t1 = 0.3 - turn,
          .t2 = 0.3 + turn,
          .t3 = 0.3 - turn,
          .t4 = 0.3 + turn,
          .t5 = 0.13 + 0.1 * std::sin(0.05 * t),
          .t6 = 0.13 + 0.1 * std::sin(0.05 * t)};
}

/// Commands at 10 Hz, truth at 50 Hz, as in a session.
void RunModel(IntegratorKind kind, double seconds) {
  const Seabed seabed{Scenario::Seabed{}};
  VehicleSimulation simulation(
      VehicleModel(VehicleParams{}, {0.05, 0.0, 0.0},
                   [&seabed](const Eigen::Vector2d& p_W) { return seabed.Depth(p_W); }),
      {}, kind);
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
    const auto shares = SurveyCommand(0.1 * (i / 5)).Shares();
    (void)simulation.Advance(Eigen::Map<const ThrusterVector>(shares.data()), Seconds(0.02));
    sum += simulation.motion().specific_force_B.x();
  }
  if (!std::isfinite(sum)) std::printf("diverged\n");
}

void RunApps(const char* integrator, double seconds) {
  EmbeddedSetup setup;
  setup.apps = {"uSimVehicle", "uSimSensors"};
  setup.blocks = {{.name = "uSimVehicle",
                   .where = {},
                   .entries = {{.key = "integrator", .value = integrator, .where = {}}}}};
  setup.globals = {{.key = "VehicleFile", .value = "feelhippo.yaml", .where = {}}};
  setup.mission_folder = LIMPET_SOURCE_DIR "/missions/table1";
  setup.session = "discovery";
  EmbeddedCommunity community(std::move(setup));
  double next_command = 0.0;
  while (community.elapsed() < Seconds(seconds)) {
    if (community.elapsed().value() >= next_command) {
      community.Poke(topics::kThrusterCommand.name,
                     TopicCodec<ThrusterCommand>::Encode(SurveyCommand(next_command)));
      next_command += 0.1;
    }
    community.Step();
  }
  community.Finish();
}

}  // namespace
}  // namespace limpet

int main() {
  using limpet::IntegratorKind;
  limpet::Measure("model, CVODE", 600.0, [] { limpet::RunModel(IntegratorKind::kCvode, 600.0); });
  limpet::Measure("model, RK4", 600.0, [] { limpet::RunModel(IntegratorKind::kRk4, 600.0); });
  limpet::Measure("uSimVehicle + uSimSensors, CVODE", 120.0,
                  [] { limpet::RunApps("cvode", 120.0); });
  limpet::Measure("uSimVehicle + uSimSensors, RK4", 120.0, [] { limpet::RunApps("rk4", 120.0); });
  return 0;
}
