// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace limpet {

/// A new folder among the system's temporary files, gone with this, also when flights in it throw.
class ScratchFolder {
 public:
  /// Named after `name`. Throws std::runtime_error if it cannot be made.
  explicit ScratchFolder(const std::string& name);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace limpet
