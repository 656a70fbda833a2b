// SPDX-License-Identifier: MIT
// What blocks of a mission take from the file of the vehicle that flies it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// Name of the global of a mission that says which vehicle flies it.
inline constexpr const char* kVehicleFileGlobal = "VehicleFile";
/// Key of a vehicle's file that names another one, which says whatever this one leaves out.
inline constexpr const char* kBasedOn = "based_on";

/// Folders that vehicles' files are looked for in, in this order: beside the mission, then
/// `share/vehicles` of the folders above the mission and above the running program.
[[nodiscard]] std::vector<std::filesystem::path> VehicleFolders(
    const std::filesystem::path& mission_folder);
/// Where `named` lies; empty if nowhere.
[[nodiscard]] std::filesystem::path FindVehicleFile(const std::filesystem::path& named,
                                                    const std::filesystem::path& mission_folder);

/// The file, the one it is based on, and so on; no more than that, so that no circle is endless.
inline constexpr std::size_t kMostVehicleFiles = 8;
[[nodiscard]] std::vector<std::filesystem::path> VehicleFileChain(
    const std::filesystem::path& file);

/// A parameter of a block that is a fact of the vehicle.
struct VehicleTaker {
  const char* owner;  ///< process
  const char* key;
  const char* vehicle_key;  ///< `section.key` of the vehicle's file
  int part = -1;            ///< of a list there: which element; -1: all of it
  /// The app reads the file itself; its block may say it only as the file does.
  bool is_former = false;
};
[[nodiscard]] const std::vector<VehicleTaker>& VehicleTakers();

/// The key of the vehicle's file that stands in for a parameter; "" if none does.
[[nodiscard]] std::string_view VehicleKeyFor(std::string_view owner, std::string_view key);

/// What a vehicle's file and those it is based on say, key (`section.key`) by key, unchecked; what
/// cannot be read is left out. `vehicle_file` checks and says so.
[[nodiscard]] std::vector<ConfigEntry> VehicleEntries(const std::filesystem::path& file);

/// Gives each block what it takes from the vehicle's file and does not say itself, each entry with
/// the file's line, in place of what it was given before. A former parameter that says the same as
/// the file is dropped; one that does not is a problem of its block.
void TakeVehicle(MissionFile& mission);

}  // namespace limpet
