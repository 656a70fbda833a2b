// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limpet {

/// Holds a folder for this process, while it lives: `flock` on `<folder>/.lock`. The kernel lets go
/// of it however the process ends, so a lock is never stale. Children do not inherit it.
class FolderLock {
 public:
  /// `folder` exists. Throws Refusal, with the process that holds it, if another one does;
  /// std::runtime_error if the file cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  static constexpr const char* kFile = ".lock";

 private:
  int file_ = -1;
};

}  // namespace limpet
