// SPDX-License-Identifier: MIT
#include "limpet/runs/child_runs.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/interrupt.hpp"

namespace limpet {
namespace {

pid_t Start(const ChildRun& run) {
  // The very file that runs here, also after the program was built anew.
  constexpr const char* kProgram = "/proc/self/exe";
  std::vector<std::string> words{std::filesystem::read_symlink(kProgram).string()};
  words.insert(words.end(), run.args.begin(), run.args.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, run.log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = -1;
  const int error = posix_spawn(&child, kProgram, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw std::runtime_error("cannot start a run: " + std::generic_category().message(error));
  return child;
}

/// The exit code if the child has ended.
std::optional<int> Reap(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, WNOHANG) != child) return std::nullopt;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Children that run, by process, with their place in the list. None outlives it.
struct RunningChildren {
  RunningChildren() = default;
  RunningChildren(const RunningChildren&) = delete;
  RunningChildren& operator=(const RunningChildren&) = delete;
  /// Asks every child to end and waits: each closes its logs first.
  ~RunningChildren() {
    for (const auto& [child, index] : by_process)
      kill(child, SIGTERM);
    for (const auto& [child, index] : by_process) {
      int status = 0;
      while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
    }
  }
  /// Takes out one that has ended, if there is one.
  std::optional<ChildEnd> TakeEnded() {
    for (auto child = by_process.begin(); child != by_process.end(); ++child) {
      if (const auto exit_code = Reap(child->first)) {
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

bool RunChildren(const std::vector<ChildRun>& runs, int jobs,
                 const std::function<bool(const ChildEnd&)>& on_end) {
  RunningChildren running;
  std::size_t next = 0;
  while (next < runs.size() || !running.by_process.empty()) {
    while (next < runs.size() && running.by_process.size() < static_cast<std::size_t>(jobs)) {
      running.by_process.emplace(Start(runs[next]), next);
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
