// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "limpet/sweeps/batch_launcher.hpp"

namespace limpet {

/// `mpirun -n workers+1 limpet_mpi <batch>/tasks.json`: rank 0 hands tasks out to the others. If
/// this process is killed, so is mpirun; its ranks take a few seconds to end.
class MpiLauncher final : public BatchLauncher {
 public:
  /// Throws Refusal without limpet_mpi beside this program, or without mpirun in PATH.
  explicit MpiLauncher(std::vector<std::string> words);
  MpiLauncher(const MpiLauncher&) = delete;
  MpiLauncher& operator=(const MpiLauncher&) = delete;
  ~MpiLauncher() override;

  void TakeUp(const std::filesystem::path& batch_folder) override { earlier_ = batch_folder; }
  void Start(const std::filesystem::path& batch_folder, int workers) override;
  [[nodiscard]] bool IsAlive() override;
  void Cancel() override;

 private:
  std::vector<std::string> words_;
  std::optional<pid_t> mpirun_;
  std::filesystem::path earlier_;  ///< where ranks of another driver may still work; empty: nowhere
};

}  // namespace limpet
