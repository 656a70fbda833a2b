// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/child_runs.hpp"

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

#include "apps/limpet/session_runner.hpp"

namespace limpet {
namespace {

pid_t Start(const ChildRun& run) {
  static const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words{program};
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
  const int error = posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
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

/// Asks every child to end and waits: each closes its logs first.
void EndAll(const std::map<pid_t, std::size_t>& running) {
  for (const auto& [child, index] : running)
    kill(child, SIGTERM);
  for (const auto& [child, index] : running) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
  }
}

}  // namespace

bool RunChildren(const std::vector<ChildRun>& runs, int jobs,
                 const std::function<void(const ChildEnd&)>& on_end) {
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  while (next < runs.size() || !running.empty()) {
    if (interrupt_requested) {
      EndAll(running);
      return false;
    }
    while (next < runs.size() && running.size() < static_cast<std::size_t>(jobs)) {
      running.emplace(Start(runs[next]), next);
      ++next;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    for (auto child = running.begin(); child != running.end();) {
      const auto exit_code = Reap(child->first);
      if (!exit_code) {
        ++child;
        continue;
      }
      const ChildEnd end{child->second, *exit_code};
      child = running.erase(child);
      if (!interrupt_requested) on_end(end);
    }
  }
  return true;
}

}  // namespace limpet
