// SPDX-License-Identifier: MIT
#include "limpet/sweeps/task_batch.hpp"

#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/sweeps/child_runs.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBatchFormat = "limpet-tasks-1";
constexpr const char* kWorkersFile = "workers";

/// Holds a task's claim while it lives, if it could be had.
class Claim {
 public:
  explicit Claim(const fs::path& file)
      : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    is_held_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  ~Claim() {
    if (file_ >= 0) ::close(file_);
  }
  [[nodiscard]] bool is_held() const { return is_held_; }

 private:
  int file_ = -1;
  bool is_held_ = false;
};

void WriteOrThrow(const fs::path& file, const std::string& text) {
  if (const auto error = WriteDurably(file, text)) throw std::runtime_error(error->text);
}

}  // namespace

std::string TaskBatch::Text() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ChildRun& task : tasks) {
    list.push_back({{"program", task.program}, {"args", task.args}, {"log", task.log.string()}});
  }
  const nlohmann::ordered_json json{
      {"format", kBatchFormat}, {"folder", folder.string()}, {"tasks", list}};
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Expected<TaskBatch> TaskBatch::FromText(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.at("format") != kBatchFormat) return Error{"of another format"};
    TaskBatch batch{.folder = json.at("folder").get<std::string>()};
    for (const nlohmann::json& task : json.at("tasks")) {
      batch.tasks.push_back({.args = task.at("args").get<std::vector<std::string>>(),
                             .log = task.at("log").get<std::string>(),
                             .program = task.at("program").get<std::string>()});
    }
    return batch;
  } catch (const nlohmann::json::exception& error) {
    return Error{error.what()};
  }
}

void BatchFolder::Begin(const TaskBatch& batch) const {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  WriteOrThrow(TasksFile(), batch.Text());
}

std::optional<TaskBatch> BatchFolder::Batch() const {
  const Expected<std::string> text = ReadWhole(TasksFile());
  if (!text) return std::nullopt;
  Expected<TaskBatch> batch = TaskBatch::FromText(*text);
  return batch ? std::optional(*std::move(batch)) : std::nullopt;
}

fs::path BatchFolder::EndFile(std::size_t task) const {
  return folder_ / fmt::format("{}.end", task);
}

std::optional<int> BatchFolder::EndOf(std::size_t task) const {
  const Expected<std::string> text = ReadWhole(EndFile(task));
  if (!text) return std::nullopt;
  const auto code = ParseInteger(text->substr(0, text->find('\n')));
  return code ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

void BatchFolder::Clear() const { fs::remove_all(folder_); }

std::optional<int> BatchFolder::RunTask(const TaskBatch& batch, std::size_t task) const {
  const Claim claim(folder_ / fmt::format("{}.claim", task));
  if (!claim.is_held() || fs::exists(EndFile(task))) return std::nullopt;
  int exit_code = 0;
  const bool has_ended = RunChildren({batch.tasks[task]}, 1, [&exit_code](const ChildEnd& end) {
    exit_code = end.exit_code;
    return true;
  });
  if (!has_ended) return std::nullopt;
  WriteOrThrow(EndFile(task), fmt::format("{}\n", exit_code));
  return exit_code;
}

WorkerMark::WorkerMark(const fs::path& batch_folder)
    : file_(::open((batch_folder / kWorkersFile).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (file_ < 0 || ::flock(file_, LOCK_SH) != 0) {
    throw std::runtime_error(fmt::format("cannot lock {}", OneLine(batch_folder.string())));
  }
}

WorkerMark::~WorkerMark() { ::close(file_); }

bool WorkerMark::IsAnyIn(const fs::path& batch_folder) {
  const int file = ::open((batch_folder / kWorkersFile).c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  const bool is_free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return !is_free;
}

bool WorkOn(const fs::path& tasks_file) {
  const BatchFolder folder(fs::absolute(tasks_file).parent_path());
  const std::optional<TaskBatch> batch = folder.Batch();
  if (!batch) {
    throw std::runtime_error(
        fmt::format("{} lists no tasks that can be read", OneLine(tasks_file.string())));
  }
  fs::current_path(batch->folder);
  for (std::size_t task = 0; task < batch->tasks.size() && !interrupt_requested; ++task)
    static_cast<void>(folder.RunTask(*batch, task));
  return !interrupt_requested;
}

}  // namespace limpet
