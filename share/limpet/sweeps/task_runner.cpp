// SPDX-License-Identifier: MIT
#include "limpet/sweeps/task_runner.hpp"

#include <algorithm>
#include <thread>

#include "limpet/core/config.hpp"
#include "limpet/sweeps/batch_runner.hpp"
#include "limpet/sweeps/mpi_launcher.hpp"
#include "limpet/sweeps/slurm_launcher.hpp"

namespace limpet {
namespace {

class LocalRunner final : public TaskRunner {
 public:
  explicit LocalRunner(int jobs) : jobs_(jobs) {}
  [[nodiscard]] bool Run(const std::vector<ChildRun>& tasks, const OnChildEnd& on_end) override {
    return RunChildren(tasks, jobs_, on_end);
  }

 private:
  int jobs_;
};

}  // namespace

std::unique_ptr<TaskRunner> MakeTaskRunner(const RunnerOptions& options) {
  if (options.runner == "slurm") {
    return std::make_unique<BatchRunner>(options, std::make_unique<SlurmLauncher>(options.words));
  }
  if (options.runner == "mpi") {
    return std::make_unique<BatchRunner>(options, std::make_unique<MpiLauncher>(options.words));
  }
  return std::make_unique<LocalRunner>(options.jobs);
}

std::vector<CommandOption> RunnerCommandOptions() {
  return {{.names = "--jobs",
           .value = "J",
           .meaning = "runs at a time (default: one per core of this machine)",
           .rule = WholeNumber(1)},
          {.names = "--runner",
           .value = "R",
           .meaning = "who runs them: local, slurm (an array of J jobs), mpi (J ranks beside rank "
                      "0); all give the same results",
           .fallback = "local",
           .rule = OneOf({"local", "slurm", "mpi"})},
          {.names = "--runner-options",
           .value = "WORDS",
           .meaning = "more words for sbatch or mpirun, e.g. \"--partition=main --time=600\"",
           .fallback = ""}};
}

RunnerOptions RunnerOptionsOf(const Arguments& given, const std::filesystem::path& out) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  RunnerOptions options{.runner = *given.Find("runner"),
                        .jobs = given.Has("jobs") ? given.Integer("jobs") : cores,
                        .batch_folder = out / "batch"};
  for (const std::string& word : Split(given.Find("runner-options").value_or(""), ' ')) {
    if (!Trim(word).empty()) options.words.emplace_back(Trim(word));
  }
  return options;
}

}  // namespace limpet
