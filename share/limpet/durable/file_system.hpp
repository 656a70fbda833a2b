// SPDX-License-Identifier: MIT
// The calls that change what is on a disk. Whatever must survive a power cut makes them through
// here, so that a test may lose what was not synced, and a fault may refuse what is asked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

namespace limpet {

/// A file that is open for writing; it closes itself. Not thread-safe.
class WritableFile {
 public:
  WritableFile() = default;
  WritableFile(const WritableFile&) = delete;
  WritableFile& operator=(const WritableFile&) = delete;
  virtual ~WritableFile() = default;

  /// All of `bytes`; after trouble a part of them may be there.
  [[nodiscard]] virtual std::error_code WriteAt(std::uint64_t offset, std::string_view bytes) = 0;
  [[nodiscard]] virtual std::error_code Truncate(std::uint64_t size) = 0;
  /// Brings content and size to the disk, not the name: that is the folder's.
  [[nodiscard]] virtual std::error_code Sync() = 0;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
};

/// The disk as programs change it. Reading goes past it: what was written is read back at once.
/// Thread-safe; its files are not.
class FileSystem {
 public:
  enum class Opening { kEmpty, kAsItIs };
  struct Opened {
    std::unique_ptr<WritableFile> file;  ///< null: `trouble` says why
    std::error_code trouble;
    bool is_new = false;  ///< its name is not on the disk before its folder is synced
  };

  FileSystem() = default;
  FileSystem(const FileSystem&) = delete;
  FileSystem& operator=(const FileSystem&) = delete;
  virtual ~FileSystem() = default;

  /// Creates the file if it is missing.
  [[nodiscard]] virtual Opened Open(const std::filesystem::path& path, Opening how) = 0;
  [[nodiscard]] virtual std::error_code Rename(const std::filesystem::path& from,
                                               const std::filesystem::path& to) = 0;
  /// One more name (a hard link) for the file `existing`: one content, which stays until both
  /// names are removed. `file_exists` if the name is taken.
  [[nodiscard]] virtual std::error_code Link(const std::filesystem::path& existing,
                                             const std::filesystem::path& name) = 0;
  /// A file, or an empty folder.
  [[nodiscard]] virtual std::error_code Remove(const std::filesystem::path& path) = 0;
  /// One folder in one that is there; `file_exists` if the name is taken.
  [[nodiscard]] virtual std::error_code CreateFolder(const std::filesystem::path& path) = 0;
  /// Brings the names in the folder to the disk.
  [[nodiscard]] virtual std::error_code SyncFolder(const std::filesystem::path& path) = 0;
  /// Bytes that are left where `path` is; nothing if nobody can tell.
  [[nodiscard]] virtual std::optional<std::uint64_t> Room(
      const std::filesystem::path& path) const = 0;
};

/// Whether Link failed for want of hard links, where a copy may still succeed: FAT and some network
/// mounts have none, others no more of one file, none reach another disk.
[[nodiscard]] bool IsWithoutLinks(const std::error_code& trouble);

/// The machine's own.
[[nodiscard]] FileSystem& RealFileSystem();

}  // namespace limpet
