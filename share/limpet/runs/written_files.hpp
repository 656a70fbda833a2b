// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace limpet {

/// Which files of a folder Limpet wrote, kept in the folder itself (`.written.json`): nothing else
/// is ever written over or removed there. Paths are relative to the folder. A name is on the list
/// before its file is made, so that a crash leaves no file that nobody owns up to.
class WrittenFiles {
 public:
  /// Reads the folder's list; an empty one if there is none. Throws Refusal if it is damaged.
  explicit WrittenFiles(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// True for a regular file on the list, reached through no symbolic link.
  [[nodiscard]] bool Owns(const std::filesystem::path& file) const;
  /// Files (and links, pipes...) under `part` of the folder that are not Limpet's; `part` itself if
  /// it is no folder.
  [[nodiscard]] std::vector<std::filesystem::path> StrangersIn(
      const std::filesystem::path& part) const;

  /// About to be written. Throws Refusal if one is there that Limpet did not write.
  void Claim(const std::vector<std::filesystem::path>& files);
  /// Not there any more, and not Limpet's if it comes back.
  void Forget(const std::vector<std::filesystem::path>& files);
  /// Whatever lies under `part` was written just now.
  void ClaimAllIn(const std::filesystem::path& part);
  /// Removes what is on the list, in or under `part`, and the folders that this leaves empty.
  void Remove(const std::filesystem::path& part);
  /// Removes all that is on the list but for what lies in one of the folders `kept`.
  void RemoveAllBut(const std::vector<std::string>& kept);
  /// What is on the list under `part`.
  [[nodiscard]] std::vector<std::filesystem::path> FilesIn(const std::filesystem::path& part) const;

  /// Folders that are being filled: after a crash nobody knows what in them is Limpet's.
  void Begin(const std::filesystem::path& part);
  /// The folder is full: what is in it was written since Begin.
  void End(const std::filesystem::path& part);
  [[nodiscard]] bool IsBegun(const std::filesystem::path& part) const;
  /// Moves a folder that a crash left begun out of the way; where to, or "" if it is not there.
  [[nodiscard]] std::filesystem::path SetAside(const std::filesystem::path& part);

  static constexpr const char* kFile = ".written.json";

 private:
  void RemoveIf(const std::function<bool(const std::string&)>& is_wanted);
  void Save() const;
  [[nodiscard]] bool IsReal(const std::filesystem::path& relative) const;

  std::filesystem::path folder_;
  std::set<std::string> files_;  ///< generic paths
  std::set<std::string> begun_;
};

/// Throws Refusal that names what lies in the way (a few of it) and what to do.
[[noreturn]] void RefuseStrangers(const std::filesystem::path& folder,
                                  const std::vector<std::filesystem::path>& strangers);

}  // namespace limpet
