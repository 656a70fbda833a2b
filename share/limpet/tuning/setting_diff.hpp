// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limpet/preflight/mission_reading.hpp"
#include "limpet/tuning/parameter_space.hpp"

namespace limpet {

/// What must change in a mission's files, fragments that it includes among them, so that it says a
/// setting.
struct SettingDiff {
  std::filesystem::path root;        ///< where `patch -p1` applies it
  std::vector<std::string> files{};  ///< that it changes, relative to root
  std::string text{};                ///< empty: nothing
};

/// A line that says the parameter is changed; else one is put into the block, and into a mission
/// file that has no such block, a block. Throws ConfigError.
[[nodiscard]] SettingDiff DiffOf(const MissionReading& mission, const ParameterSpace& space,
                                 const SettingValues& values);

}  // namespace limpet
