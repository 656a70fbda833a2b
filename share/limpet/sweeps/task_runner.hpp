// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "limpet/console/command.hpp"
#include "limpet/sweeps/child_runs.hpp"

namespace limpet {

/// Who runs the tasks of a sweep, and how many at a time.
struct RunnerOptions {
  std::string runner = "local";  ///< local, slurm, mpi
  int jobs = 1;
  std::vector<std::string> words{};      ///< more words for sbatch or mpirun
  std::filesystem::path batch_folder{};  ///< of slurm and mpi: shared with the nodes
};

/// Runs tasks, each a process of its own. What a task gives does not depend on who runs it.
class TaskRunner {
 public:
  TaskRunner() = default;
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;
  virtual ~TaskRunner() = default;

  /// Runs the tasks as RunChildren does: each is run once, `on_end` is called in this thread as
  /// each ends. False if it said stop or the user interrupted.
  [[nodiscard]] virtual bool Run(const std::vector<ChildRun>& tasks, const OnChildEnd& on_end) = 0;
};

/// REQUIRES: a runner that is known. Throws Refusal if this machine lacks what it needs.
[[nodiscard]] std::unique_ptr<TaskRunner> MakeTaskRunner(const RunnerOptions& options);

/// `--jobs`, `--runner` and `--runner-options`, for a Command, and what they say.
[[nodiscard]] std::vector<CommandOption> RunnerCommandOptions();
[[nodiscard]] RunnerOptions RunnerOptionsOf(const Arguments& given,
                                            const std::filesystem::path& out);

}  // namespace limpet
