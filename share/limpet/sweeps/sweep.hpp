// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/runs/run_configuration.hpp"
#include "limpet/runs/run_folder.hpp"
#include "limpet/sweeps/task_runner.hpp"

namespace limpet {

/// One survey of a sweep.
struct SweepTask {
  std::vector<std::string> settings;  ///< `owner.key=value`, as `--set` takes them
  std::uint64_t seed = 1;
};

struct SweepPlan {
  std::filesystem::path mission_folder, out;
  std::vector<std::string> survey_options{};  ///< of every task
  RunnerOptions runner{};
  std::string program{};    ///< that knows `survey`; empty: this one
  bool keeps_runs = false;  ///< logs and maps of every run, not only what it was worth
  /// Called before the first run of a list and after each: how many are done, and how many there
  /// are to do.
  std::function<void(std::size_t done, std::size_t all)> on_progress{};
};

/// Surveys of one mission with many settings and seeds, each done once, with the results on disk:
/// `<out>/results/<checksum of the settings>/<seed>.json` is the run's report.json, less what
/// depends on the machine. Killed anywhere, another sweep of the same folder goes on; two at a time
/// are refused, and so is a folder whose results were made by another mission or program.
class Sweep {
 public:
  /// Throws Refusal.
  explicit Sweep(SweepPlan plan);

  /// The result of every task, in order; done ones are not run again. A run that left no report
  /// gives `{"failed": exit code}`. Nothing if the user interrupted. Throws Refusal if a run was
  /// refused, or if mission or program changed meanwhile.
  [[nodiscard]] std::optional<std::vector<std::string>> Results(
      const std::vector<SweepTask>& tasks);

  /// Files of the sweep's owner, in its folder.
  [[nodiscard]] RunFolder& folder() { return folder_; }
  /// How many tasks were run by this object, and how many were found done.
  [[nodiscard]] std::size_t run() const { return run_; }
  [[nodiscard]] std::size_t found() const { return found_; }
  /// File with a task's result, relative to the sweep's folder: by the task's settings and seed.
  [[nodiscard]] static std::filesystem::path ResultFile(const SweepTask& task);

 private:
  [[nodiscard]] ChildRun RunOf(const SweepTask& task) const;
  [[nodiscard]] std::filesystem::path WorkFolder(const SweepTask& task) const;
  /// Tasks without a result; what a driver left that was killed before it took it is taken now.
  [[nodiscard]] std::vector<SweepTask> Missing(const std::vector<SweepTask>& tasks);
  void Take(const SweepTask& task, int exit_code);
  /// Once all of `tasks` are done: another run may be about to write into one of them.
  void RemoveEmptyFolders(const std::vector<SweepTask>& tasks) const;
  void RefuseIfChanged() const;

  SweepPlan plan_;
  RunFolder folder_;
  RunConfiguration configuration_;
  std::unique_ptr<TaskRunner> runner_;
  std::size_t run_ = 0, found_ = 0;
};

/// A report.json without what depends on the machine that flew it.
[[nodiscard]] std::string MachineFreeReport(const std::string& report_json);

}  // namespace limpet
