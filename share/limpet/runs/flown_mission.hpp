// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limpet {

/// The mission file that a flight of `named` is of: the file itself, mission.moos in a folder, or
/// of a folder with several missions, as those of several communities, the one that simulates a
/// vehicle. Throws ConfigError if none of them does, or several do.
[[nodiscard]] std::filesystem::path FlownMissionAt(const std::filesystem::path& named);

}  // namespace limpet
