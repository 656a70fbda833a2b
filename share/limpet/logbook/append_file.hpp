// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// A file that grows at its end, by whole pieces: what a full disk takes of a piece is cut off
/// again, so that the next one never lands behind half a line.
class AppendFile {
 public:
  /// Creates or empties `path`.
  [[nodiscard]] static Expected<AppendFile> Create(const std::filesystem::path& path);
  /// Goes on at the end of `path`, which is created if need be.
  [[nodiscard]] static Expected<AppendFile> Continue(const std::filesystem::path& path);
  /// The same with a file of lines: half a line at its end goes.
  [[nodiscard]] static Expected<AppendFile> ContinueLines(const std::filesystem::path& path);
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  ~AppendFile();

  /// Hands all of `bytes` to the system, or none of them and says false.
  [[nodiscard]] bool Append(std::string_view bytes);
  /// Writes over what is there. REQUIRES: offset + bytes.size() <= size().
  [[nodiscard]] bool Overwrite(std::uint64_t offset, std::string_view bytes);
  /// Brings everything appended to the disk; free if there is nothing new.
  [[nodiscard]] bool Sync();
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  explicit AppendFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  bool is_synced_ = true;
};

/// Brings the names in `folder` to the disk: a new file is safe only once its name is.
void SyncFileNames(const std::filesystem::path& folder);

}  // namespace limpet
