// SPDX-License-Identifier: MIT
#include "limpet/mission/outside.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace limpet {
namespace {

namespace fs = std::filesystem;

bool IsBelow(const fs::path& path, const fs::path& folder) {
  const auto [in_folder, in_path] = std::ranges::mismatch(folder, path);
  // A folder that ends in `/` ends with an empty name.
  return in_folder == folder.end() || (in_folder->empty() && std::next(in_folder) == folder.end());
}

bool IsLogger(std::string_view program) {
  return EqualsIgnoringCase(program, "pLog") || EqualsIgnoringCase(program, "pLogger");
}

/// Blocks that a logger reads: those of its name, and those it is launched under.
std::vector<std::string> LoggerBlocks(const MissionFile& mission) {
  std::vector<std::string> names{"pLog", "pLogger"};
  for (const LaunchEntry& entry : mission.launches) {
    if (IsLogger(fs::path(entry.binary).filename().string()) && !IsLogger(entry.moos_name)) {
      names.push_back(entry.moos_name);
    }
  }
  return names;
}

constexpr const char* kRule =
    "`{}` lies outside; a mission writes to its own folder, the run folder and the working "
    "directory; --allow-outside lets it write anywhere";

/// The complaint about one line of a logger's block, if there is one.
std::optional<std::string> LoggerLineProblem(const ConfigEntry& entry,
                                             const std::vector<fs::path>& folders) {
  const bool is_path = EqualsIgnoringCase(entry.key, "Path") ||
                       EqualsIgnoringCase(entry.key, "LoggingDirectorySummaryFile");
  if (is_path && !LiesInside(entry.value, ".", folders)) {
    return fmt::format(kRule, entry.value);
  }
  const bool is_name = EqualsIgnoringCase(entry.key, "File");
  if (is_name && (entry.value.find('/') != std::string::npos || entry.value.starts_with(".."))) {
    return fmt::format(
        "`{}` is a path; allowed: a name without `/`, or any path with --allow-outside",
        entry.value);
  }
  return std::nullopt;
}

}  // namespace

bool LiesInside(const fs::path& path, const fs::path& base, const std::vector<fs::path>& folders) {
  std::error_code failure;
  // A shell would read ~ as a home.
  const bool is_home = path.string().starts_with('~');
  const fs::path whole = fs::weakly_canonical(fs::absolute(base / path, failure), failure);
  return !failure && !is_home && std::ranges::any_of(folders, [&whole](const fs::path& folder) {
    std::error_code ignored;
    const fs::path real = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
    return !ignored && IsBelow(whole, real);
  });
}

std::optional<std::string> ProcessNameProblem(std::string_view name) {
  constexpr std::string_view kMarks = "_-.+@#";
  constexpr std::size_t kLongest = 64;
  const bool has_allowed_letters = std::ranges::all_of(name, [&](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           kMarks.find(letter) != std::string_view::npos;
  });
  const bool is_allowed = has_allowed_letters && !name.empty() && name.size() <= kLongest &&
                          !name.starts_with('.') && !name.starts_with('-');
  return is_allowed ? std::nullopt
                    : std::optional(fmt::format(
                          "`{}` is no name for a process and its log; allowed: up to {} letters, "
                          "digits and {}, the first no . or -",
                          name.substr(0, 2 * kLongest), kLongest, kMarks));
}

std::vector<ConfigProblem> OutsideProblems(const MissionFile& mission,
                                           const std::vector<fs::path>& folders) {
  std::vector<ConfigProblem> problems;
  for (const ConfigEntry& entry : mission.globals) {
    if (EqualsIgnoringCase(entry.key, "GlobalLogPath") && !LiesInside(entry.value, ".", folders)) {
      problems.push_back({entry.where, entry.key, fmt::format(kRule, entry.value)});
    }
  }
  for (const std::string& name : LoggerBlocks(mission)) {
    const ConfigBlock* block = mission.Block(name);
    for (const ConfigEntry& entry :
         block != nullptr ? block->entries : std::vector<ConfigEntry>()) {
      if (const auto complaint = LoggerLineProblem(entry, folders)) {
        problems.push_back({entry.where, entry.key, *complaint});
      }
    }
  }
  return problems;
}

}  // namespace limpet
