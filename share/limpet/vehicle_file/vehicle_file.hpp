// SPDX-License-Identifier: MIT
// vehicle.yaml: the vehicle as data, for all who need to know it. docs/vehicle-file.md lists its
// keys.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limpet/core/camera_params.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/key_section.hpp"
#include "limpet/core/params.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/vehicle/battery_sheet.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// What a vehicle's file says. Lengths from the body origin, the centre of buoyancy; axes forward,
/// starboard, down (FRD); SI units.
struct VehicleFile {
  std::string name;
  VehicleParams params;
  SensorSheets sensors;
  BatterySheet battery;
  CameraParams camera;
  CameraTiming camera_timing;
};

/// From text; `file` names it in problems and says where the one it is based on is looked for.
/// Throws ConfigError with every problem: unknown
/// keys, wrong types, values out of range, thrusters that are missing or cannot move the vehicle.
[[nodiscard]] VehicleFile ParseVehicleFile(const std::string& text, const std::string& file);
[[nodiscard]] VehicleFile LoadVehicleFile(const std::filesystem::path& file);

/// The vehicle of a mission, by the value of its global. Throws ConfigError that says where it was
/// looked for and what there is.
[[nodiscard]] VehicleFile LoadMissionVehicle(const std::string& named,
                                             const std::filesystem::path& mission_folder);

/// Sections of the file: the reader's and the documentation's source.
[[nodiscard]] std::vector<KeySection> VehicleFileSections(VehicleFile& vehicle);

}  // namespace limpet
