// SPDX-License-Identifier: MIT
#include "limpet/sweeps/child_process.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limpet {
namespace {

constexpr const char* kOwnProgram = "/proc/self/exe";
constexpr int kNotStarted = 127;  // as a shell says it

int ExitCodeOf(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// What the child does between fork and exec: only what is safe there.
[[noreturn]] void Become(const char* program, char* const* argv, const char* log, int signal,
                         pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, signal);
  if (::getppid() != parent) ::_exit(kNotStarted);
  const int nothing = ::open("/dev/null", O_RDONLY);
  const int output = ::open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (nothing < 0 || output < 0) ::_exit(kNotStarted);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execvp(program, argv);
  ::_exit(kNotStarted);
}

}  // namespace

std::filesystem::path OwnProgram() { return std::filesystem::read_symlink(kOwnProgram); }

pid_t StartChild(const ChildRun& run, int signal_if_orphaned) {
  std::vector<std::string> words{run.program.empty() ? OwnProgram().string() : run.program};
  words.insert(words.end(), run.args.begin(), run.args.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  const char* program = run.program.empty() ? kOwnProgram : run.program.c_str();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) Become(program, argv.data(), run.log.c_str(), signal_if_orphaned, parent);
  if (child < 0)
    throw std::runtime_error("cannot start a run: " + std::generic_category().message(errno));
  return child;
}

std::optional<int> ReapChild(pid_t child) {
  int status = 0;
  if (::waitpid(child, &status, WNOHANG) != child) return std::nullopt;
  return ExitCodeOf(status);
}

int WaitForChild(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return ExitCodeOf(status);
}

}  // namespace limpet
