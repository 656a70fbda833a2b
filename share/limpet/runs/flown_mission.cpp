// SPDX-License-Identifier: MIT
#include "limpet/runs/flown_mission.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "limpet/mission/mission_file.hpp"
#include "limpet/runs/session_runner.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

bool SimulatesAVehicle(const fs::path& file) {
  const std::vector<std::string> apps = EmbeddedApps(LoadMission(file));
  return std::ranges::find(apps, "uSimVehicle") != apps.end();
}

}  // namespace

fs::path FlownMissionAt(const fs::path& named) {
  fs::path usual = MissionFileAt(named);
  if (fs::exists(usual) || !fs::is_directory(named)) return usual;
  std::vector<fs::path> flown;
  for (const fs::directory_entry& entry : fs::directory_iterator(named)) {
    if (entry.path().extension() == ".moos" && SimulatesAVehicle(entry.path())) {
      flown.push_back(entry.path());
    }
  }
  if (flown.size() == 1) return flown.front();
  throw ConfigError({.where = {.file = named.string(), .line = 0},
                     .key = "",
                     .text = std::string(flown.empty() ? "none" : "several") +
                             " of its missions launch uSimVehicle; name the .moos to fly"});
}

}  // namespace limpet
