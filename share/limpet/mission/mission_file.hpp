// SPDX-License-Identifier: MIT
// Mission files (.moos): globals, one block per process, and what to launch.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/plug.hpp"

namespace limpet {

/// One `Run = binary @ options ~ name` of the ANTLER block.
struct LaunchEntry {
  std::string binary;
  std::string moos_name;             ///< base name of the binary unless given
  std::vector<ConfigEntry> options;  ///< NewConsole, ExtraProcessParams, ...
  SourceLine where;
};

struct MissionFile {
  std::string file;
  std::vector<ConfigEntry>
      globals;  ///< outside of blocks; values without blanks, as MOOS reads them
  std::vector<ConfigBlock> blocks;  ///< the first of each name
  std::vector<LaunchEntry> launches;
  std::vector<ConfigProblem> warnings;  ///< what MOOS would silently ignore

  /// The ProcessConfig block of an app (case ignored), or nullptr.
  [[nodiscard]] const ConfigBlock* Block(std::string_view name) const;
  /// The first global of that name (case ignored), or "". Unlike MOOS, blocks are not searched.
  [[nodiscard]] std::string Global(std::string_view key) const;
};

/// How .moos and .bhv files treat plugs: macros they do not know stay, since viewers and conditions
/// have `$(...)` of their own; fragments are looked for beside the file, then in PlugFoldersAround.
[[nodiscard]] PlugOptions MissionPlugOptions(const std::filesystem::path& file);

/// Lines of a mission or behavior file, expanded first if it has plug directives. Warnings go to
/// `warnings`. Throws ConfigError.
[[nodiscard]] std::vector<TextLine> ConfigLines(std::string_view text,
                                                const std::filesystem::path& file,
                                                const PlugOptions& options,
                                                std::vector<ConfigProblem>& warnings);

/// Throws ConfigError with every problem. Stricter than MOOS: a line in a block that is neither a
/// comment nor `key = value`, and a `${NAME}` that nothing defines, are problems.
[[nodiscard]] MissionFile ParseMission(std::string_view text, const std::string& file);
[[nodiscard]] MissionFile ParseMission(std::string_view text, const std::string& file,
                                       const PlugOptions& options);
[[nodiscard]] MissionFile LoadMission(const std::filesystem::path& file);

}  // namespace limpet
