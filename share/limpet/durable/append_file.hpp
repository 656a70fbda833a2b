// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "limpet/core/expected.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// A file that grows at its end, by whole pieces: what a full disk takes of a piece is cut off
/// again, so that the next one never lands behind half a line. Not thread-safe.
class AppendFile {
 public:
  /// Creates or empties `path`.
  [[nodiscard]] static Expected<AppendFile> Create(const std::filesystem::path& path,
                                                   FileSystem& disk = RealFileSystem());
  /// Goes on at the end of `path`, which is created if need be.
  [[nodiscard]] static Expected<AppendFile> Continue(const std::filesystem::path& path,
                                                     FileSystem& disk = RealFileSystem());
  /// Goes on behind the first `size` bytes of `path`; what follows them goes. REQUIRES: it has as
  /// many.
  [[nodiscard]] static Expected<AppendFile> ContinueAt(const std::filesystem::path& path,
                                                       std::uint64_t size, FileSystem& disk);
  /// Goes on at the end of a file of lines, which is created if need be; half a line at its end
  /// goes.
  [[nodiscard]] static Expected<AppendFile> ContinueLines(const std::filesystem::path& path,
                                                          FileSystem& disk = RealFileSystem());

  /// Hands all of `bytes` to the system, or none of them and says false.
  [[nodiscard]] bool Append(std::string_view bytes);
  /// Writes over what is there. REQUIRES: offset + bytes.size() <= size().
  [[nodiscard]] bool Overwrite(std::uint64_t offset, std::string_view bytes);
  /// Brings everything appended to the disk, and the name of a new file; free if there is nothing
  /// new. After false what was appended since the last true may be lost.
  [[nodiscard]] bool Sync();
  /// Removes it from the disk. The last call.
  void Discard();
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Why the last call said false; nothing after one that said true.
  [[nodiscard]] std::error_code trouble() const { return trouble_; }

 private:
  AppendFile(std::filesystem::path path, FileSystem& disk) : path_(std::move(path)), disk_(&disk) {}
  [[nodiscard]] static Expected<AppendFile> Open(const std::filesystem::path& path,
                                                 FileSystem::Opening how, FileSystem& disk);
  [[nodiscard]] bool IsFine(std::error_code trouble);

  std::filesystem::path path_;
  FileSystem* disk_;
  std::unique_ptr<WritableFile> file_;
  std::uint64_t size_ = 0;
  bool is_synced_ = true;
  bool has_new_name_ = false;  ///< that is not on the disk yet
  std::error_code trouble_;
};

}  // namespace limpet
