// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/sensors/simulated_battery.hpp"
#include "limpet/simulation/tidal_current.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/thruster_watchdog.hpp"
#include "limpet/vehicle/vehicle_params.hpp"
#include "limpet/vehicle/vehicle_simulation.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {

/// The vehicle in its water: THRUSTER_COMMAND in, the truth out. A command holds until the next,
/// but for a second at most: as any driver must, it stops its thrusters when the pilot falls
/// silent. What it draws, its battery gives, until that switches off and nothing turns any more.
class SimVehicleApp final : public App {
 public:
  struct Params {
    std::string scenario = "scenario.yaml";
    std::string integrator = "cvode";
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("scenario", scenario, "Truth of the mission, relative to its folder");
      visit.Choice("integrator", integrator, "cvode: the reference; rk4: faster, for many runs",
                   {"cvode", "rk4"});
    }
  };

  SimVehicleApp(const AppContext& context, const Params& params);
  /// The app with a scenario made in code, in place of the mission's file.
  SimVehicleApp(const AppContext& context, const Params& params, const Scenario& scenario);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void OnCommand(const Stamped<ThrusterCommand>& command);
  /// Warns, in a community, of faults of the scenario that nobody makes there.
  void WarnOfFaultsNotMade();
  void OnFormerTruth(const Stamped<SimTruth>& truth);
  void OnFormerBattery(const Stamped<SimBattery>& battery);
  [[nodiscard]] bool AwaitsFormerTruth(Seconds now);
  /// Moves on to `end`, `duration` after the last step.
  void Move(Seconds duration, Seconds end);
  /// The water's current, and what a fault of the scenario adds.
  [[nodiscard]] Eigen::Vector2d CurrentAt(Seconds end, Seconds duration);
  /// The command in force at `time`; keeps the account of it.
  [[nodiscard]] ThrusterVector ThrustAt(Seconds time);
  void NoteZero(bool is_zero, Seconds time);
  void TellThrust(Seconds now);
  /// BATTERY, of a vehicle that has one or of a scenario's fault, and the truth of it.
  void TellBattery();

  VehicleFile file_;
  VehicleParams vehicle_;
  Scenario scenario_;
  std::string integrator_;
  TidalCurrent current_;
  VehicleSimulation simulation_;
  bool has_place_ = true;  ///< false after a restart, until the place of the former life is known
  std::optional<Seconds> waits_since_;
  std::optional<SimulatedBattery> battery_;
  bool has_battery_recalled_ = false;
  ThrusterWatchdog watchdog_;
  FaultSchedule faults_;
  double current_more_ = 0.0;  ///< northwards [m/s]
  SimThrust thrust_;
  bool is_zero_ = true, is_stale_ = false;
  std::optional<Seconds> thrust_told_;
  std::optional<Seconds> last_tick_;
};

}  // namespace limpet
