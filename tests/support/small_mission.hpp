// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "limpet/mission/expanded_text.hpp"
#include "tests/support/limpet_command.hpp"

namespace limpet {

/// The scenario of a small mission: one object that stays and one that goes and comes back. Its
/// name tries to clear the screen.
inline const std::string kSmallScenario = R"(seabed: {depth_m: 6.0, roughness_m: 0.03, seed: 2}
water:  {visibility_m: 6}
start:  {north_m: -3.0, east_m: -3.0, heading_deg: 0}
opis:
  - {name: "\e[2Jstays", color: yellow, radius_m: 0.3, discovery: [2, 1, 5.2], change: [2, 1, 5.2], third: [2, 1, 5.2]}
  - {name: goes, color: orange, radius_m: 0.3, discovery: [-2, 2, 5.4], change: null, third: [-2, 2, 5.4]}
camera: boxes
)";

/// `missions/basin` as a mission of 8 x 8 m that takes a second or so per session: written to
/// `folder`, which is made.
inline void WriteSmallMission(const std::filesystem::path& folder) {
  const std::filesystem::path basin =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(basin / "mission.bhv", folder / "mission.bhv");
  std::string text = ExpandedText(TextOfFile(basin / "mission.moos"), basin / "mission.moos");
  const std::map<std::string, std::string> values{{"area_north_min_m", "-4"},
                                                  {"area_north_max_m", "4"},
                                                  {"area_east_min_m", "-4"},
                                                  {"area_east_max_m", "4"},
                                                  {"coverage_target", "0.6"}};
  for (const auto& [key, value] : values) {
    text = std::regex_replace(text, std::regex("(" + key + "\\s*=\\s*)\\S+"), "$01" + value);
  }
  std::ofstream(folder / "mission.moos") << text;
  std::ofstream(folder / "scenario.yaml") << kSmallScenario;
}

}  // namespace limpet
