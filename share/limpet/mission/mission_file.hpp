// SPDX-License-Identifier: MIT
// Mission files (.moos): globals, one block per process, and what to launch.
#pragma once

#include <filesystem>
#include <functional>
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
  std::vector<std::string> fact_files;  ///< whose lines stand in blocks

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

/// Reads a mission as MOOS does, gives each block what it takes from the globals and does not say
/// itself (shared_settings.hpp), from the vehicle's file (vehicle_settings.hpp) and for a stock
/// program that ours stands in for (stand_ins.hpp), and says what MOOS ignores: what stands outside
/// of blocks in `warnings`, and what stands in a block (nested braces, a line that is neither a
/// comment nor `key = value`, a `${NAME}` that nothing defines) in the block's `problems`: only the
/// app whose block it is knows if that matters, and of the ANTLER block whoever launches it. Throws
/// ConfigError with every problem of the rest.
[[nodiscard]] MissionFile ReadMission(std::string_view text, const std::string& file,
                                      const PlugOptions& options);
[[nodiscard]] MissionFile LoadMission(const std::filesystem::path& file);
/// The file of the mission that `named` is: a mission's folder, or the file itself.
[[nodiscard]] std::filesystem::path MissionFileAt(const std::filesystem::path& named);

/// Like ReadMission for a text that is wholly ours: problems in any block are thrown too.
[[nodiscard]] MissionFile ParseMission(std::string_view text, const std::string& file);
[[nodiscard]] MissionFile ParseMission(std::string_view text, const std::string& file,
                                       const PlugOptions& options);

/// What a reader should know: the warnings, and the problems of those blocks that are not `ours`.
[[nodiscard]] std::vector<ConfigProblem> NotesOf(
    const MissionFile& mission, const std::function<bool(const std::string& block)>& is_ours);

}  // namespace limpet
