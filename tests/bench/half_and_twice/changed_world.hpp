// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limpet {

/// A mission in a world where one thing is not as the vehicle believes.
struct ChangedWorld {
  /// A key of a scenario's flow mapping, and the number that it is given.
  struct Entry {
    std::string key;
    double value = 0.0;
  };
  std::string name;               ///< of its folder
  std::string what;               ///< is changed, for a table
  std::string errors{};           ///< scenario.yaml's `errors:`
  std::vector<Entry> scenario{};  ///< what else is changed there
  std::string settings{};         ///< more of the command line
};

/// The world as believed, each thing halved and doubled, and then dropouts in a current.
[[nodiscard]] std::vector<ChangedWorld> ChangedWorlds();

/// Copies `mission`, with its scenario changed, to `folder`. Throws if the scenario lacks a key.
void WriteMission(const ChangedWorld& world, const std::filesystem::path& mission,
                  const std::filesystem::path& folder);

}  // namespace limpet
