// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "limpet/mission/mission_places.hpp"
#include "limpet/preflight/checks.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet::internal {
namespace {

/// Those whose work depends on which vehicle it is.
constexpr std::array<std::string_view, 7> kNeedVehicle{
    "pPilot", "pNav", "pHelm", "pMap", "uSimVehicle", "uSimSensors", "uSimCamera"};

/// Slower ones leave pNav without an attitude, or without bottom track, from one sample to the
/// next.
constexpr Hertz kSlowestImu{5.0}, kSlowestDvl{1.0};

/// Longest arm of the DVL: with 1 m pNav was as good as with 0.2 m, with 2 m it was not.
constexpr Meters kLongestArm{1.5};

void CheckRate(const MissionReading& reading, const char* key, Hertz rate, Hertz slowest,
               MissionProblems& found) {
  if (rate >= slowest) return;
  found.syntax.push_back({reading.InVehicle(key), key,
                          fmt::format("`{:g}`: pNav cannot navigate by samples that rare; allowed: "
                                      "{:g} Hz and more",
                                      rate.value(), slowest.value())});
}

/// What a vehicle lacks for an app that the mission launches.
void CheckSensorsFor(const MissionReading& reading, MissionProblems& found) {
  if (!reading.vehicle() || !reading.Launches("pNav")) return;
  const VehicleFile& vehicle = *reading.vehicle();
  if (!vehicle.sensors.imu.is_present) {
    found.syntax.push_back({reading.InVehicle("imu.present"), "imu.present",
                            "`false`: pNav has no attitude without an IMU; allowed: true"});
  }
  CheckRate(reading, "imu.rate_hz", vehicle.sensors.imu.rate, kSlowestImu, found);
  CheckRate(reading, "dvl.rate_hz", vehicle.sensors.dvl.rate, kSlowestDvl, found);
  const double arm = vehicle.sensors.dvl.p_BD.norm();
  if (arm > kLongestArm.value()) {
    found.syntax.push_back(
        {reading.InVehicle("dvl.at_m"), "dvl.at_m",
         fmt::format("{:.2f} m from the body's origin: from so far pNav takes turns for false "
                     "velocities; allowed: up to {:g} m",
                     arm, kLongestArm.value())});
  }
  const auto wait = reading.Find("pNav", "frame_wait_s");
  const double latency = vehicle.camera_timing.latency.value();
  if (wait && latency >= wait->number()) {
    found.syntax.push_back(
        {reading.InVehicle("camera.latency_s"), "camera.latency_s",
         fmt::format("`{:g}`: {} gives up frames that come so late; allowed: less than that, or a "
                     "longer frame_wait_s",
                     latency, wait->Named())});
  }
}

}  // namespace

bool CheckVehicle(const MissionReading& reading, MissionProblems& found) {
  const std::string named = reading.mission().Global(kVehicleFileGlobal);
  std::string needed_by;
  for (const std::string_view app : kNeedVehicle) {
    if (needed_by.empty() && reading.Launches(app) && !reading.StandsIn(app)) needed_by = app;
  }
  if (named.empty() && needed_by.empty()) return true;
  CheckSensorsFor(reading, found);
  auto& list =
      IsOthersAlone(reading.mission()) ? found.notes : found.syntax;  // theirs says another
  try {
    static_cast<void>(LoadMissionVehicle(named, reading.folder()));
    return true;
  } catch (const ConfigError& error) {
    for (ConfigProblem problem : error.problems()) {
      if (problem.where.file.empty())
        problem.where = LineOfGlobal(reading.mission(), kVehicleFileGlobal);
      if (named.empty())
        problem.text = fmt::format("{} needs this global, which {}", needed_by, problem.text);
      list.push_back(std::move(problem));
    }
    return false;
  }
}

}  // namespace limpet::internal
