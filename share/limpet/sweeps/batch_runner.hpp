// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <set>

#include "limpet/sweeps/batch_launcher.hpp"
#include "limpet/sweeps/task_batch.hpp"
#include "limpet/sweeps/task_runner.hpp"

namespace limpet {

/// Runs tasks by workers that somebody else starts (Slurm, MPI), through a shared folder. Workers
/// take tasks until none is left, so that each has as much to do as there is. A task that was
/// killed, or whose worker was lost, is handed out again, at most kMostAttempts times in all; then
/// its end is reported as it was, kLost if it has none. After this driver was killed, a new one
/// takes up what still runs.
class BatchRunner final : public TaskRunner {
 public:
  static constexpr int kMostAttempts = 3;
  static constexpr int kLost = 255;  ///< exit code of a task that left no end

  BatchRunner(const RunnerOptions& options, std::unique_ptr<BatchLauncher> launcher);
  [[nodiscard]] bool Run(const std::vector<ChildRun>& tasks, const OnChildEnd& on_end) override;

 private:
  enum class Goes { kOn, kStopped };
  /// Watches until nobody works on the batch any more. `tasks` tells by its place in the batch
  /// which of the caller's a task is.
  [[nodiscard]] Goes Watch(const std::map<std::size_t, std::size_t>& tasks, bool is_last,
                           const OnChildEnd& on_end);
  [[nodiscard]] Goes Collect(const std::map<std::size_t, std::size_t>& tasks, bool is_last,
                             const OnChildEnd& on_end);
  [[nodiscard]] Goes TakeUpEarlier(const std::vector<ChildRun>& tasks, const OnChildEnd& on_end);
  [[nodiscard]] Goes RunMissing(const std::vector<ChildRun>& tasks, bool is_last,
                                const OnChildEnd& on_end);
  void Stop();

  BatchFolder folder_;
  int workers_;
  std::unique_ptr<BatchLauncher> launcher_;
  std::set<std::size_t> reported_;  ///< of the caller's tasks
};

}  // namespace limpet
