// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/sweeps/batch_launcher.hpp"

namespace limpet {

/// `sbatch --array`: each element takes tasks until none is left. `squeue` says whether any is
/// still there. Elements go on when this process is killed; the job's number is in
/// `<batch>/job`.
class SlurmLauncher final : public BatchLauncher {
 public:
  /// Throws Refusal without sbatch in PATH.
  explicit SlurmLauncher(std::vector<std::string> words);

  void TakeUp(const std::filesystem::path& batch_folder) override;
  void Start(const std::filesystem::path& batch_folder, int workers) override;
  /// Asks at most once a second. Throws std::runtime_error if Slurm does not answer for minutes.
  [[nodiscard]] bool IsAlive() override;
  void Cancel() override;

 private:
  std::vector<std::string> words_;
  std::filesystem::path folder_;
  std::string job_;  ///< empty: none that may be alive
  int unanswered_ = 0;
};

}  // namespace limpet
