// SPDX-License-Identifier: MIT
#include "apps/uSimVehicle/sim_vehicle_app.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "apps/uSimVehicle/sim_vehicle_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/mission/fault_names.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {
namespace {

/// A process started again waits this long for the place of its former life (MOOS time).
constexpr Seconds kLongestWait(2.0);
/// In a community, a tick that comes later makes up for what the sensors have missed (MOOS time).
constexpr Seconds kLongestStep(0.03);
constexpr double kMostSteps = 50.0;     ///< after a long halt they are longer
constexpr double kCurrentGrowth = 0.2;  ///< of a current that sets in [m/s^2]
constexpr Seconds kThrustPeriod(1.0);   ///< of SIM_THRUST while nothing changes

VehicleSimulation::Place StartOf(const Scenario& scenario) {
  return {.north = scenario.start.north_m,
          .east = scenario.start.east_m,
          .yaw = RadiansFromDegrees(scenario.start.heading_deg),
          .down = std::nullopt};
}

/// The vehicle as it truly is: its thrusters are not quite those of its file.
VehicleParams WithErrors(VehicleParams vehicle, const ThrusterErrorParams& error) {
  vehicle.thrusters.max_thrust_n *= error.thrust_factor;
  vehicle.thrusters.lag_s *= error.lag_factor;
  return vehicle;
}

VehicleSimulation MakeSimulation(const VehicleParams& vehicle, const Scenario& scenario,
                                 const std::string& integrator,
                                 const VehicleSimulation::Place& place) {
  const Scenario::Water& water = scenario.water;
  VehicleModel model(
      vehicle, {water.current_north_mps, water.current_east_mps, 0.0},
      [seabed = Seabed(scenario.seabed)](const Eigen::Vector2d& p_W) { return seabed.Depth(p_W); });
  return {std::move(model), place,
          integrator == "rk4" ? IntegratorKind::kRk4 : IntegratorKind::kCvode};
}

SimTruth TruthOf(const VehicleMotion& motion) {
  const Pose& pose = motion.X_WB;
  return {.north = pose.p_WB.x(),
          .east = pose.p_WB.y(),
          .down = pose.p_WB.z(),
          .roll = pose.roll,
          .pitch = pose.pitch,
          .yaw = pose.yaw,
          .u = motion.v_WB_B.x(),
          .v = motion.v_WB_B.y(),
          .w = motion.v_WB_B.z(),
          .p = motion.omega_B.x(),
          .q = motion.omega_B.y(),
          .r = motion.omega_B.z(),
          .fx = motion.specific_force_B.x(),
          .fy = motion.specific_force_B.y(),
          .fz = motion.specific_force_B.z()};
}

}  // namespace

SimVehicleApp::SimVehicleApp(const AppContext& context, const Params& params)
    : SimVehicleApp(context, params, LoadScenario(context.mission_folder / params.scenario)) {}

SimVehicleApp::SimVehicleApp(const AppContext& context, const Params& params,
                             const Scenario& scenario)
    : App(context),
      file_(LoadMissionVehicle(context.Global(kVehicleFileGlobal), context.mission_folder)),
      vehicle_(WithErrors(file_.params, scenario.errors.thrusters)),
      scenario_(scenario),
      integrator_(params.integrator),
      current_(scenario.water.current,
               {scenario.water.current_north_mps, scenario.water.current_east_mps},
               MakeRandom("current")),
      simulation_(MakeSimulation(vehicle_, scenario, params.integrator, StartOf(scenario))),
      has_place_(!context.is_restarted),
      faults_(scenario.faults) {
  for (const std::string& variable : faults_.Variables()) {
    SubscribeRaw(variable, [this](const MessagePtr& message) {
      faults_.Hear(message->name, message->value);
    });
  }
  if (context.runs_live && !context.makes_host_faults) WarnOfFaultsNotMade();
  Subscribe(topics::kThrusterCommand, &SimVehicleApp::OnCommand);
  if (file_.battery.is_present) {
    battery_.emplace(file_.battery, scenario.errors.battery, MakeRandom("battery"));
  }
  if (context.is_restarted) {
    Subscribe(topics::kSimTruth, &SimVehicleApp::OnFormerTruth);
    Subscribe(topics::kSimBattery, &SimVehicleApp::OnFormerBattery);
  }
}

void SimVehicleApp::WarnOfFaultsNotMade() {
  std::string names;
  for (const ScenarioFault& fault : faults_.faults()) {
    const FaultKind* kind = FindFaultKind(fault.what);
    if (kind == nullptr || kind->made_by != kMadeByHost) continue;
    names += (names.empty() ? "" : ", ") + fault.what;
  }
  if (!names.empty()) {
    Warn(warnings::kFaultNotMade,
         "only pLaunch, and embedded sessions, make these of the scenario: " + names);
  }
}

void SimVehicleApp::OnFormerTruth(const Stamped<SimTruth>& truth) {
  if (!has_place_) {
    has_place_ = true;
    const SimTruth& last = truth.value;
    simulation_ = MakeSimulation(
        vehicle_, scenario_, integrator_,
        {.north = last.north, .east = last.east, .yaw = last.yaw, .down = last.down});
  }
}

void SimVehicleApp::OnFormerBattery(const Stamped<SimBattery>& battery) {
  if (!battery_ || std::exchange(has_battery_recalled_, true)) return;
  battery_.emplace(file_.battery, scenario_.errors.battery, MakeRandom("battery"),
                   battery.value.charge);
}

bool SimVehicleApp::AwaitsFormerTruth(Seconds now) {
  waits_since_ = waits_since_.value_or(now);
  has_place_ = has_place_ || now - *waits_since_ > kLongestWait;
  return !has_place_;
}

void SimVehicleApp::OnCommand(const Stamped<ThrusterCommand>& command) {
  const auto shares = command.value.Shares();
  const std::size_t count = file_.params.thrusters.thrusters.size();
  if (std::any_of(shares.begin() + count, shares.end(),
                  [](double share) { return share != 0.0; })) {
    Warn(warnings::kCommandRefused,
         fmt::format("THRUSTER_COMMAND is for more thrusters than the vehicle's {}: not obeyed",
                     count));
  } else if (watchdog_.Hear(Eigen::Map<const ThrusterVector>(shares.data()), now())) {
    ClearWarning(warnings::kCommandRefused);
  } else {
    Warn(warnings::kCommandRefused,
         "THRUSTER_COMMAND is not finite or beyond full thrust: not obeyed");
  }
}

void SimVehicleApp::Tick(Seconds now) {
  watchdog_.KeepUp(now);
  if (AwaitsFormerTruth(now)) {
    return;
  }
  faults_.Update(now);
  const Seconds since = last_tick_.value_or(now);
  last_tick_ = now;
  const double most = context().runs_live ? kMostSteps : 1.0;  // embedded, no tick is late
  const double steps =
      std::clamp(std::ceil((now - since).value() / kLongestStep.value()), 1.0, most);
  for (double step = 1.0; step <= steps; step += 1.0) {
    const Seconds end = since + (now - since) * (step / steps);
    Move((now - since) * (1.0 / steps), end);
    PublishMeasured(topics::kSimTruth, TruthOf(simulation_.motion()), end);
  }
  if (!thrust_told_ || now - *thrust_told_ >= kThrustPeriod) {
    TellThrust(now);
  }
}

ThrusterVector SimVehicleApp::ThrustAt(Seconds time) {
  const bool is_stale = watchdog_.IsStale(time);
  if (is_stale && !is_stale_) {
    ++thrust_.stops;
    Warn(warnings::kCommandStale, "no THRUSTER_COMMAND for 1 s: all thrusters stopped");
  } else if (!is_stale) {
    ClearWarning(warnings::kCommandStale);
  }
  is_stale_ = is_stale;
  ThrusterVector thrust = watchdog_.At(time);
  thrust_.greatest = thrust.cwiseAbs().maxCoeff();
  if (thrust_.greatest > 0.0) {
    thrust_.oldest_obeyed = std::max(thrust_.oldest_obeyed, watchdog_.Age(time)->value());
  }
  return thrust;
}

void SimVehicleApp::NoteZero(bool is_zero, Seconds time) {
  if (is_zero == is_zero_) {
    return;
  }
  is_zero_ = is_zero;
  if (is_zero) {
    thrust_.zero_at = time.value();
  }
  ReportEvent(events::kThrusters, is_zero ? "thrusters at rest" : "thrusters at work");
  TellThrust(time);
}

void SimVehicleApp::TellThrust(Seconds now) {
  thrust_told_ = now;
  thrust_.refused = watchdog_.refused();
  Publish(topics::kSimThrust, thrust_);
  if (faults_.Has(fault_names::kLeak))
    Publish(topics::kLeak, faults_.Active(fault_names::kLeak) != nullptr);
  if (faults_.Has(fault_names::kLinkLost) && faults_.Active(fault_names::kLinkLost) == nullptr) {
    Publish(topics::kShoreBeat, now.value());
  }
  TellBattery();
}

void SimVehicleApp::TellBattery() {
  if (battery_) {
    Publish(topics::kBattery, battery_->Gauge(faults_));
    Publish(topics::kSimBattery, battery_->Truth());
  } else if (faults_.Has(fault_names::kBattery)) {
    const ScenarioFault* low = faults_.Active(fault_names::kBattery);
    Publish(topics::kBattery,
            BatteryState{.charge = low != nullptr ? low->size : 1.0, .volts = {}, .amperes = {}});
  }
}

Eigen::Vector2d SimVehicleApp::CurrentAt(Seconds end, Seconds duration) {
  const ScenarioFault* more = faults_.Active(fault_names::kCurrent);
  const double most = kCurrentGrowth * duration.value();
  const double wanted = more != nullptr ? more->size : 0.0;
  current_more_ += std::clamp(wanted - current_more_, -most, most);
  return current_.At(end, simulation_.state()(state_index::kPosition + 2)) +
         Eigen::Vector2d(current_more_, 0.0);
}

void SimVehicleApp::Move(Seconds duration, Seconds end) {
  const ThrusterVector thrust = ThrustAt(end);
  NoteZero(thrust_.greatest == 0.0, end);
  if (duration <= Seconds(0.0)) {
    return;
  }
  const Eigen::Vector2d current = CurrentAt(end, duration);
  simulation_.SetCurrent({current.x(), current.y(), 0.0});
  const double most = scenario_.errors.thrusters.saturates_at;
  ThrusterVector given = thrust.cwiseMax(-most).cwiseMin(most);
  if (const ScenarioFault* weak = faults_.Active(fault_names::kThrustersWeak)) given *= weak->size;
  if (battery_) {
    battery_->Draw(given, duration, faults_);
    if (battery_->is_off()) {
      given.setZero();
      Warn(warnings::kBatteryOff, "the battery has switched off: nothing turns any more");
    }
  }
  for (const TimedEvent& event : simulation_.Advance(given, duration)) {
    ReportEvent(events::kSimulatedEvent, EventName(event.event));
    Publish(topics::kSimEvent, std::string(EventName(event.event)));
  }
  if (simulation_.failures() > 0) {
    Warn(warnings::kIntegratorFailed, "CVODE gave up a step; fixed steps bridged it");
  }
}

void SimVehicleApp::Report(ReportLines& report) const {
  const VehicleMotion& motion = simulation_.motion();
  const Eigen::Vector3d& p_WB = motion.X_WB.p_WB;
  report.Add("The truth, for who runs the simulation:");
  report.Pair("Position", fmt::format("north {:.2f}, east {:.2f}, down {:.2f} m", p_WB.x(),
                                      p_WB.y(), p_WB.z()));
  report.Pair("Heading", fmt::format("{:.1f} deg", MoosHeadingFromYaw(motion.X_WB.yaw)));
  report.Pair("Velocity", fmt::format("{:.2f} ahead, {:.2f} to starboard, {:.2f} down m/s",
                                      motion.v_WB_B.x(), motion.v_WB_B.y(), motion.v_WB_B.z()));
  report.Pair("Thrust", fmt::format("{:.2f} at most; stopped {} times for want of a command, {} "
                                    "commands refused",
                                    thrust_.greatest, thrust_.stops, watchdog_.refused()));
  if (battery_) {
    const SimBattery battery = battery_->Truth();
    report.Pair("Battery",
                fmt::format("{:.0f} % of {:.0f} Wh, {:.1f} Wh used{}", 100.0 * battery.charge,
                            battery.capacity_wh, battery.used_wh, battery.is_off ? ", off" : ""));
  }
  report.Pair("Integrator", fmt::format("{} steps given up", simulation_.failures()));
}

LIMPET_REGISTER_APP(SimVehicleApp, "uSimVehicle", 50.0);

}  // namespace limpet
