// SPDX-License-Identifier: MIT
// Tasks that other processes than the driver run: a file that lists them, and beside it a claim and
// an end of each. All that a cluster's nodes share is this folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/sweeps/child_process.hpp"

namespace limpet {

struct TaskBatch {
  std::filesystem::path folder;   ///< the working folder of every task
  std::vector<ChildRun> tasks{};  ///< each with its program, told apart by their logs

  [[nodiscard]] std::string Text() const;
  [[nodiscard]] static Expected<TaskBatch> FromText(const std::string& text);
};

/// `<folder>/tasks.json` and what lies beside it.
class BatchFolder {
 public:
  explicit BatchFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  [[nodiscard]] std::filesystem::path TasksFile() const { return folder_ / "tasks.json"; }
  void Clear() const;
  /// Removes what an earlier batch left and writes the new list. Throws std::runtime_error.
  void Begin(const TaskBatch& batch) const;
  /// Nothing if there is none that can be read.
  [[nodiscard]] std::optional<TaskBatch> Batch() const;

  /// The exit code of a task that has ended.
  [[nodiscard]] std::optional<int> EndOf(std::size_t task) const;

  /// Runs one task and writes down its end, unless another process has claimed it or it has ended
  /// already: then nothing. A claim ends with the process that holds it.
  [[nodiscard]] std::optional<int> RunTask(const TaskBatch& batch, std::size_t task) const;

 private:
  [[nodiscard]] std::filesystem::path EndFile(std::size_t task) const;
  std::filesystem::path folder_;
};

/// Says that this process works on a batch, while it lives: also when its driver is gone.
class WorkerMark {
 public:
  explicit WorkerMark(const std::filesystem::path& batch_folder);
  WorkerMark(const WorkerMark&) = delete;
  WorkerMark& operator=(const WorkerMark&) = delete;
  ~WorkerMark();

  /// Whether any process of this machine says so.
  [[nodiscard]] static bool IsAnyIn(const std::filesystem::path& batch_folder);

 private:
  int file_ = -1;
};

/// Runs every task of `tasks_file` that nobody else has taken, one after the other. False if
/// interrupted. Throws std::runtime_error if the file cannot be read.
[[nodiscard]] bool WorkOn(const std::filesystem::path& tasks_file);

}  // namespace limpet
