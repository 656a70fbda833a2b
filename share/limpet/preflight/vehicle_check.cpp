// SPDX-License-Identifier: MIT
#include <array>

#include <fmt/format.h>

#include "limpet/preflight/checks.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet::internal {
namespace {

/// Those whose work depends on which vehicle it is.
constexpr std::array kNeedVehicle{"pPilot", "pNav", "uSimVehicle", "uSimSensors", "uSimCamera"};

SourceLine LineOfGlobal(const MissionFile& mission) {
  for (const ConfigEntry& global : mission.globals) {
    if (EqualsIgnoringCase(global.key, kVehicleFileGlobal)) return global.where;
  }
  return {.file = mission.file, .line = 0};
}

}  // namespace

void CheckVehicle(const MissionReading& reading, MissionProblems& found) {
  const std::string named = reading.mission().Global(kVehicleFileGlobal);
  std::string needed_by;
  for (const char* app : kNeedVehicle) {
    if (needed_by.empty() && reading.Launches(app)) needed_by = app;
  }
  if (named.empty() && needed_by.empty()) return;
  try {
    static_cast<void>(LoadMissionVehicle(named, reading.folder()));
  } catch (const ConfigError& error) {
    for (ConfigProblem problem : error.problems()) {
      if (problem.where.file.empty()) problem.where = LineOfGlobal(reading.mission());
      if (named.empty())
        problem.text = fmt::format("{} needs this global, which {}", needed_by, problem.text);
      found.syntax.push_back(std::move(problem));
    }
  }
}

}  // namespace limpet::internal
