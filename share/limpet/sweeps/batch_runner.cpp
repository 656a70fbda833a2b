// SPDX-License-Identifier: MIT
#include "limpet/sweeps/batch_runner.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "limpet/core/interrupt.hpp"

namespace limpet {
namespace {

constexpr std::chrono::milliseconds kPause(200);
constexpr int kKilled = 128;  // exit codes from here on: by a signal

std::string NameOf(const ChildRun& task) {
  return std::filesystem::absolute(task.log).lexically_normal().string();
}

}  // namespace

BatchRunner::BatchRunner(const RunnerOptions& options, std::unique_ptr<BatchLauncher> launcher)
    : folder_(std::filesystem::absolute(options.batch_folder)),
      workers_(options.jobs),
      launcher_(std::move(launcher)) {}

bool BatchRunner::Run(const std::vector<ChildRun>& tasks, const OnChildEnd& on_end) {
  reported_.clear();
  if (tasks.empty()) return true;
  if (TakeUpEarlier(tasks, on_end) == Goes::kStopped) return false;
  for (int attempt = 1; attempt <= kMostAttempts && reported_.size() < tasks.size(); ++attempt) {
    if (RunMissing(tasks, attempt == kMostAttempts, on_end) == Goes::kStopped) return false;
  }
  folder_.Clear();
  return true;
}

BatchRunner::Goes BatchRunner::TakeUpEarlier(const std::vector<ChildRun>& tasks,
                                             const OnChildEnd& on_end) {
  const std::optional<TaskBatch> earlier = folder_.Batch();
  if (!earlier) return Goes::kOn;
  std::map<std::size_t, std::size_t> known;
  for (std::size_t i = 0; i < earlier->tasks.size(); ++i) {
    const auto same = std::ranges::find(tasks, NameOf(earlier->tasks[i]), NameOf);
    const auto place = static_cast<std::size_t>(same - tasks.begin());
    if (same != tasks.end() && same->args == earlier->tasks[i].args) known[i] = place;
  }
  launcher_->TakeUp(folder_.path());
  return Watch(known, false, on_end);
}

BatchRunner::Goes BatchRunner::RunMissing(const std::vector<ChildRun>& tasks, bool is_last,
                                          const OnChildEnd& on_end) {
  TaskBatch batch{.folder = std::filesystem::current_path()};
  std::map<std::size_t, std::size_t> places;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (reported_.contains(i)) continue;
    places[batch.tasks.size()] = i;
    ChildRun task = tasks[i];
    task.log = NameOf(task);
    if (task.program.empty()) task.program = OwnProgram().string();
    batch.tasks.push_back(std::move(task));
  }
  folder_.Begin(batch);
  launcher_->Start(folder_.path(), std::min(workers_, static_cast<int>(batch.tasks.size())));
  if (Watch(places, is_last, on_end) == Goes::kStopped) return Goes::kStopped;
  if (!is_last) return Goes::kOn;
  for (const auto& [in_batch, place] : places) {
    if (reported_.contains(place)) continue;
    if (!on_end({.index = place, .exit_code = kLost})) return Goes::kStopped;
    reported_.insert(place);
  }
  return Goes::kOn;
}

BatchRunner::Goes BatchRunner::Watch(const std::map<std::size_t, std::size_t>& tasks, bool is_last,
                                     const OnChildEnd& on_end) {
  while (true) {
    // Asked first: what ended before the workers did is then on the disk.
    const bool is_alive = launcher_->IsAlive();
    if (interrupt_requested || Collect(tasks, is_last, on_end) == Goes::kStopped) {
      Stop();
      return Goes::kStopped;
    }
    if (!is_alive) return Goes::kOn;
    std::this_thread::sleep_for(kPause);
  }
}

BatchRunner::Goes BatchRunner::Collect(const std::map<std::size_t, std::size_t>& tasks,
                                       bool is_last, const OnChildEnd& on_end) {
  for (const auto& [in_batch, place] : tasks) {
    if (reported_.contains(place)) continue;
    const std::optional<int> end = folder_.EndOf(in_batch);
    if (!end || (*end >= kKilled && !is_last)) continue;
    if (!on_end({.index = place, .exit_code = *end})) return Goes::kStopped;
    reported_.insert(place);
  }
  return Goes::kOn;
}

void BatchRunner::Stop() {
  constexpr int kMostWaits = 100;
  launcher_->Cancel();
  for (int i = 0; i < kMostWaits && launcher_->IsAlive(); ++i)
    std::this_thread::sleep_for(kPause);
  if (!interrupt_requested) folder_.Clear();
}

}  // namespace limpet
