// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_rules.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limpet/core/program_search.hpp"
#include "limpet/mission/outside.hpp"
#include "limpet/mission/process_name.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// The line that names a folder for the program: the process's own, else that of the whole block.
const ConfigEntry* FolderLine(const LaunchEntry& entry, const MissionFile& mission) {
  const ConfigEntry* line = OptionOf(entry, "Path");
  const ConfigBlock* antler = mission.Block("ANTLER");
  if (line == nullptr && antler != nullptr) {
    line = antler->Find("ExecutablePath");
  }
  return line == nullptr || EqualsIgnoringCase(line->value, "SYSTEM") ? nullptr : line;
}

}  // namespace

const ConfigEntry* OptionOf(const LaunchEntry& entry, std::string_view name) {
  const auto found = std::ranges::find_if(entry.options, [name](const ConfigEntry& option) {
    return EqualsIgnoringCase(option.key, name);
  });
  return found == entry.options.end() ? nullptr : &*found;
}

std::optional<fs::path> ProgramFolder(const LaunchEntry& entry, const MissionFile& mission) {
  const ConfigEntry* line = FolderLine(entry, mission);
  if (line == nullptr) {
    return std::nullopt;
  }
  return fs::absolute(mission.file).parent_path() / line->value;
}

std::optional<ConfigProblem> ProgramProblem(const LaunchEntry& entry, const MissionFile& mission,
                                            const fs::path& own_folder) {
  if (!IsNameOfMoosProcess(entry.binary)) {
    return ConfigProblem{
        entry.where, "Run",
        fmt::format("`{}` is not the plain name of a MOOS process (p, i or u and a capital letter, "
                    "no path): a mission starts no other program; --allow-outside starts it",
                    entry.binary)};
  }
  const ConfigEntry* line = FolderLine(entry, mission);
  if (line == nullptr) {
    return std::nullopt;
  }
  std::vector<fs::path> trusted = FoldersOnPath();
  trusted.push_back(own_folder);
  trusted.push_back(fs::absolute(mission.file).parent_path());
  const fs::path folder = fs::absolute(mission.file).parent_path() / line->value;
  if (LiesInside(folder, ".", trusted)) {
    return std::nullopt;
  }
  return ConfigProblem{
      line->where, line->key,
      fmt::format("`{}` is no folder of PATH, nor the mission's: programs come from beside the "
                  "launcher and from PATH; --allow-outside takes them from there",
                  line->value)};
}

std::optional<std::string> ArgumentProblem(const std::vector<std::string>& args) {
  constexpr std::array<std::string_view, 4> kLaunchers{"run_folder", "prior_folder", "session",
                                                       "allow_outside"};
  for (const std::string& arg : args) {
    const std::string_view body =
        std::string_view(arg).substr(std::min(arg.find_first_not_of('-'), arg.size()));
    const bool is_switch = arg.starts_with('-');
    if (is_switch &&
        std::ranges::find(kLaunchers, body.substr(0, body.find('='))) != kLaunchers.end()) {
      return fmt::format(
          "`{}` is for the launcher to say, not for the mission; --allow-outside "
          "lets it pass",
          arg);
    }
  }
  return std::nullopt;
}

std::optional<fs::path> FindProgram(const std::string& binary, const std::optional<fs::path>& named,
                                    const fs::path& own_folder) {
  std::vector<fs::path> folders = FoldersOnPath();
  folders.insert(folders.begin(), own_folder);
  if (named) {
    folders.insert(folders.begin(), *named);
  }
  for (const fs::path& folder : folders) {
    if (IsExecutable(folder / binary)) {
      return folder / binary;
    }
  }
  return std::nullopt;
}

bool IsDispensable(std::string_view binary) {
  const bool is_tool = binary.starts_with('u') && !binary.starts_with("uSim");
  return is_tool || binary.find("Viewer") != std::string_view::npos;
}

}  // namespace limpet
