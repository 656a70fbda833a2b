// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limpet {

/// Starts the processes that work on a batch, somewhere, and knows whether they still do.
class BatchLauncher {
 public:
  BatchLauncher() = default;
  BatchLauncher(const BatchLauncher&) = delete;
  BatchLauncher& operator=(const BatchLauncher&) = delete;
  virtual ~BatchLauncher() = default;

  /// Takes up what an earlier driver, which was killed, has started for this folder.
  virtual void TakeUp(const std::filesystem::path& batch_folder) = 0;
  /// `workers` processes that work on the folder's tasks. Throws std::runtime_error.
  virtual void Start(const std::filesystem::path& batch_folder, int workers) = 0;
  [[nodiscard]] virtual bool IsAlive() = 0;
  virtual void Cancel() = 0;
};

}  // namespace limpet
