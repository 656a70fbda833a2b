// SPDX-License-Identifier: MIT
// Files that say the facts of one thing once for all blocks of a mission: of the vehicle that flies
// it, of the detector that it uses.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// Key of such a file that names another one, which says whatever this one leaves out.
inline constexpr const char* kBasedOn = "based_on";

/// A parameter of a block that is a fact of one of these things.
struct FactTaker {
  const char* owner;  ///< process
  const char* key;
  const char* fact;                   ///< `section.key` of the file
  std::optional<std::size_t> part{};  ///< of a list there: which element; nothing: all of it
  /// The app reads the file itself; its block may say it only as the file does.
  bool is_former = false;
};

/// A kind of file.
struct FactFile {
  const char* global;  ///< of a mission, that names the file
  const char* folder;  ///< in `share`, where those are that come with Limpet
  const char* of;      ///< whose facts: "vehicle"
  std::vector<FactTaker> takers;
  /// Apps read the file for its own sake and complain about it; else blocks that take from it do.
  bool has_reader = false;
};

/// Every kind that a mission may name.
[[nodiscard]] const std::vector<const FactFile*>& FactFiles();

/// Folders that such files are looked for in, in this order: beside the mission, then
/// `share/<folder>` of the folders above the mission and above the running program.
[[nodiscard]] std::vector<std::filesystem::path> FactFolders(
    const FactFile& kind, const std::filesystem::path& mission_folder);
/// Path of the file called `named`; empty if it is nowhere.
[[nodiscard]] std::filesystem::path FindFactFile(const FactFile& kind,
                                                 const std::filesystem::path& named,
                                                 const std::filesystem::path& mission_folder);
/// Why `named` (may be empty: none is named) is not found, with the names that are.
[[nodiscard]] ConfigProblem UnknownFactFile(const FactFile& kind, const std::string& named,
                                            const std::filesystem::path& mission_folder);

/// The file, the one it is based on, and so on; no more than that, so that no circle is endless.
inline constexpr std::size_t kMostFactFiles = 8;
[[nodiscard]] std::vector<std::filesystem::path> FactFileChain(const FactFile& kind,
                                                               const std::filesystem::path& file);

/// The key of the file that stands in for a parameter, and whose file it is; nothing if none does.
struct FactSource {
  const FactFile* kind = nullptr;
  std::string_view fact;
};
[[nodiscard]] FactSource FactFor(std::string_view owner, std::string_view key);

/// What a file and those it is based on say, key (`section.key`) by key, unchecked; what cannot be
/// read is left out. Who reads the file for its own sake checks it and says so.
[[nodiscard]] std::vector<ConfigEntry> FactEntries(const FactFile& kind,
                                                   const std::filesystem::path& file);

/// Gives each block what it takes from the files that the mission names and does not say itself,
/// each entry with the file's line, in place of what it was given before. A former parameter that
/// says the same as the file is dropped; one that does not is a problem of its block.
void TakeFacts(MissionFile& mission);

}  // namespace limpet
