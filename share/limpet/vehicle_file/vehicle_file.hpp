// SPDX-License-Identifier: MIT
// vehicle.yaml: the vehicle as data, for all who need to know it. docs/vehicle-file.md lists its
// keys.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/params.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// What a vehicle's file says. Lengths from the body origin, the centre of buoyancy; axes forward,
/// starboard, down (FRD); SI units.
struct VehicleFile {
  std::string name;
  VehicleParams params;
};

/// Name of the global of a mission that says which vehicle flies it.
inline constexpr const char* kVehicleFileGlobal = "VehicleFile";

/// The same from text; `file` names it in problems. Throws ConfigError with every problem: unknown
/// keys, wrong types, values out of range, thrusters that are missing or cannot move the vehicle.
[[nodiscard]] VehicleFile ParseVehicleFile(const std::string& text, const std::string& file);
[[nodiscard]] VehicleFile LoadVehicleFile(const std::filesystem::path& file);

/// Where `named` lies: beside the mission, or in `share/vehicles` of one of the folders above the
/// mission or the running program. Empty if nowhere.
[[nodiscard]] std::filesystem::path FindVehicleFile(const std::filesystem::path& named,
                                                    const std::filesystem::path& mission_folder);
/// The vehicle of a mission, by the value of its global. Throws ConfigError that says where it was
/// looked for and what there is.
[[nodiscard]] VehicleFile LoadMissionVehicle(const std::string& named,
                                             const std::filesystem::path& mission_folder);

/// A section of the file with its keys as declared: the reader's and the documentation's source.
struct VehicleFileSection {
  std::string name;
  std::vector<ParamSpec> keys;
};
[[nodiscard]] std::vector<VehicleFileSection> VehicleFileSections(VehicleParams& params);

}  // namespace limpet
