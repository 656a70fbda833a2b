// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"

namespace limpet {

/// All that decides what a run of a seed gives, as checksums by the names of its parts: the files
/// of the mission folder, the plugs that it includes, the options, the program. Equal
/// configurations give equal runs.
struct RunConfiguration {
  std::map<std::string, std::string> parts;

  /// Of what would be run now. Left out are files that no run reads: README, pictures, hidden ones,
  /// and expect.yaml, whose bounds are held against finished runs. Throws std::runtime_error if a
  /// file cannot be read.
  [[nodiscard]] static RunConfiguration Of(const std::filesystem::path& mission_folder,
                                           const std::vector<std::string>& options);

  [[nodiscard]] std::string Text() const;
  [[nodiscard]] static Expected<RunConfiguration> FromText(const std::string& text);
};

/// What differs, for a person: `mission.bhv has changed`, `plug_camera.moos is new`; empty if
/// nothing.
[[nodiscard]] std::vector<std::string> DifferencesBetween(const RunConfiguration& before,
                                                          const RunConfiguration& now);

}  // namespace limpet
