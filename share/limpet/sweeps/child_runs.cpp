// SPDX-License-Identifier: MIT
#include "limpet/sweeps/child_runs.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <thread>

#include <signal.h>
#include <sys/types.h>

#include "limpet/core/interrupt.hpp"

namespace limpet {
namespace {

/// Children that run, by process, with their place in the list. None outlives it.
struct RunningChildren {
  RunningChildren() = default;
  RunningChildren(const RunningChildren&) = delete;
  RunningChildren& operator=(const RunningChildren&) = delete;
  /// Asks every child to end and waits: each closes its logs first.
  ~RunningChildren() {
    for (const auto& [child, index] : by_process)
      kill(child, SIGTERM);
    for (const auto& [child, index] : by_process)
      WaitForChild(child);
  }
  /// Takes out one that has ended, if there is one.
  std::optional<ChildEnd> TakeEnded() {
    for (auto child = by_process.begin(); child != by_process.end(); ++child) {
      if (const auto exit_code = ReapChild(child->first)) {
        const ChildEnd end{child->second, *exit_code};
        by_process.erase(child);
        return end;
      }
    }
    return std::nullopt;
  }
  std::map<pid_t, std::size_t> by_process;
};

}  // namespace

bool RunChildren(const std::vector<ChildRun>& runs, int jobs, const OnChildEnd& on_end) {
  RunningChildren running;
  std::size_t next = 0;
  while (next < runs.size() || !running.by_process.empty()) {
    while (next < runs.size() && running.by_process.size() < static_cast<std::size_t>(jobs)) {
      running.by_process.emplace(StartChild(runs[next], SIGKILL), next);
      ++next;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    while (const auto end = running.TakeEnded()) {
      if (!interrupt_requested && !on_end(*end)) return false;
    }
    if (interrupt_requested) return false;
  }
  return true;
}

}  // namespace limpet
