// SPDX-License-Identifier: MIT
#include "limpet/launch/supervisor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/launch/process_memory.hpp"
#include "limpet/launch/process_time.hpp"

namespace limpet {
namespace {

constexpr double kFirstPause = 0.5;  // [s]
constexpr double kLongestPause = 8.0;
constexpr double kHealthy = 60.0;
constexpr double kEarly = 5.0;
constexpr int kExecFailed = 127;
/// A launcher that was halted itself, or had no processor, has not watched for longer than this
/// between two looks, whatever the clock says.
constexpr Seconds kLongestLook(0.5);

std::string HowItEnded(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));  // NOLINT(concurrency-mt-unsafe)
  }
  const int code = WEXITSTATUS(status);
  return code == kExecFailed ? "could not be executed" : fmt::format("ended with code {}", code);
}

/// In the child: it keeps the descriptor and is told its number; -1: none, nor one of a launcher
/// above us.
void Inherit(const char* variable, int descriptor) {
  ::unsetenv(variable);  // NOLINT(concurrency-mt-unsafe): one thread here
  if (descriptor >= 0) {
    ::fcntl(descriptor, F_SETFD, 0);
    std::array<char, 12> number{};
    std::snprintf(number.data(), number.size(), "%d", descriptor);
    ::setenv(variable, number.data(), 1);  // NOLINT(concurrency-mt-unsafe)
  }
}

/// Halted (SIGSTOP). What is learned of its state here is left for others to be learned again.
bool IsStopped(pid_t child) {
  siginfo_t state{};
  return ::waitid(P_PID, static_cast<id_t>(child), &state, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
         state.si_pid == child;
}

}  // namespace

Supervisor::Supervisor(std::filesystem::path log_folder,
                       std::vector<std::pair<std::string, std::string>> environment, Say say)
    : log_folder_(std::move(log_folder)),
      environment_(std::move(environment)),
      say_(std::move(say)) {
  std::filesystem::create_directories(log_folder_);
}

Supervisor::~Supervisor() {
  End(Seconds(1.0));
  for (const Child& child : children_) {
    if (child.kept >= 0) {
      ::close(child.kept);
    }
  }
}

void Supervisor::Start(const LaunchItem& item) {
  Child& added = children_.emplace_back();
  added.item = item;
  if (item.is_database) {
    children_.back().kept = ::memfd_create("limpet-kept", MFD_CLOEXEC);
  }
  Launch(children_.back());
}

void Supervisor::Launch(Child& child) {
  // Everything that allocates is done before the fork: the child may only call what is safe there.
  std::vector<std::string> words{child.item.program.string()};
  words.insert(words.end(), child.item.args.begin(), child.item.args.end());
  std::vector<char*> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  const std::string log = (log_folder_ / (child.item.name + ".log")).string();
  const pid_t parent = ::getpid();
  child.heart.Reset();
  child.last_beat = 0;
  child.silent = child.stopped = Seconds(0.0);
  child.is_hung = false;
  child.pid = ::fork();
  if (child.pid == 0) {
    ++child.starts;
    Become(child, parent, log.c_str(), argv.data());
  }
  child.started = SteadyTime();
  child.is_due = false;
  ++child.starts;
  if (child.pid < 0) {
    child.pid = 0;
    say_(fmt::format("{} cannot be started: {}", child.item.name,
                     std::generic_category().message(errno)));
  }
}

/// The child's side of the fork.
void Supervisor::Become(const Child& child, pid_t parent, const char* log,
                        char* const* argv) const {
  ::setpgid(0, 0);                     // Ctrl-C is ours to pass on, in order
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // nothing is left over if we are killed
  if (::getppid() != parent) {
    ::_exit(kExecFailed);
  }
  const int file = ::open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file >= 0) {
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
  }
  for (const auto& [name, value] : environment_) {
    ::setenv(name.c_str(), value.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread here
  }
  if (child.starts > 1) {
    ::setenv("LIMPET_RESTARTED", "1", 1);  // NOLINT(concurrency-mt-unsafe)
  }
  if (!child.item.working_folder.empty() && ::chdir(child.item.working_folder.c_str()) != 0) {
    ::_exit(kExecFailed);
  }
  Inherit("LIMPET_KEPT_FD", child.kept);
  Inherit(Heartbeat::kVariable, child.heart.descriptor());
  if (shared_.variable != nullptr) Inherit(shared_.variable, shared_.descriptor);
  ::execv(argv[0], argv);
  ::_exit(kExecFailed);
}

bool Supervisor::Poll() {
  const Seconds now = SteadyTime();
  const Seconds passed =
      last_poll_ > Seconds(0.0) ? std::min(now - last_poll_, kLongestLook) : Seconds(0.0);
  last_poll_ = now;
  for (Child& child : children_) {
    int status = 0;
    if (child.pid > 0 && ::waitpid(child.pid, &status, WNOHANG) == child.pid) {
      child.pid = 0;
      NoteEnd(child, status);
    } else if (child.pid > 0) {
      HaltIfWanted(child);
      WatchBeat(child, passed);
    }
    if (child.is_due && !child.is_kept_down && now >= child.next_start) {
      Launch(child);
    }
  }
  return std::ranges::any_of(children_,
                             [](const Child& child) { return child.pid > 0 || child.is_due; });
}

Supervisor::Child* Supervisor::Find(const std::string& name) {
  const auto found =
      std::ranges::find(children_, name, [](const Child& child) { return child.item.name; });
  return found == children_.end() ? nullptr : &*found;
}

void Supervisor::Halt(const std::string& name, bool is_halted) {
  Child* child = Find(name);
  if (child == nullptr || child->is_halted == is_halted) return;
  child->is_halted = is_halted;
  if (!is_halted && child->pid > 0) ::kill(child->pid, SIGCONT);
}

// Before its first beat it would not be missed.
void Supervisor::HaltIfWanted(const Child& child) {
  if (child.is_halted && child.heart.count() != 0) ::kill(child.pid, SIGSTOP);
}

void Supervisor::KeepDown(const std::string& name, bool is_down) {
  Child* child = Find(name);
  if (child == nullptr || child->is_kept_down == is_down) return;
  child->is_kept_down = is_down;
  if (is_down && child->pid > 0) ::kill(child->pid, SIGKILL);
}

// One that hangs as it starts, or before it goes on, would else never be noticed. One that reads a
// large session then may be silent for long, one that is halted does nothing any more.
void Supervisor::WatchBeat(Child& child, Seconds passed) {
  const std::uint64_t beat = child.heart.count();
  child.silent = beat != child.last_beat ? Seconds(0.0) : child.silent + passed;
  child.last_beat = beat;
  child.has_beaten = child.has_beaten || beat != 0;
  child.stopped = beat == 0 && IsStopped(child.pid) ? child.stopped + passed : Seconds(0.0);
  const Seconds hung_after = child.item.hung_after;
  const Seconds patience = hung_after * (beat == 0 ? kPatienceUnwatched : 1.0);
  const bool hangs = (child.has_beaten && child.silent > patience) || child.stopped > hung_after;
  if (child.is_hung || hung_after <= Seconds(0.0) || !hangs) {
    return;
  }
  child.is_hung = true;
  say_(fmt::format("{} hangs: no sign of life for {:.1f} s; it is killed", child.item.name,
                   std::max(child.silent, child.stopped).value()));
  ::kill(child.pid, SIGKILL);  // a stopped process hears nothing else
}

void Supervisor::NoteEnd(Child& child, int status) {
  const bool is_failure = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
  const bool has_bad_configuration = WIFEXITED(status) && WEXITSTATUS(status) == 2;
  child.last_end = child.is_hung ? "hung and was killed" : HowItEnded(status);
  const std::string what = fmt::format("{} {}", child.item.name, child.last_end);
  const std::string where =
      fmt::format("; see {}", (log_folder_ / (child.item.name + ".log")).string());
  if ((SteadyTime() - child.started).value() > kHealthy) {
    child.failures = 0;
  }
  const bool is_wanted = child.item.restart == RestartPolicy::kAlways ||
                         (is_failure && child.item.restart == RestartPolicy::kOnFailure);
  child.failures += is_failure ? 1 : 0;
  if (!is_wanted) {
    say_(is_failure ? what + where : what);
    child.is_given_up = is_failure;
    has_given_up_ = has_given_up_ || is_failure;
    return;
  }
  if (has_bad_configuration || child.failures >= kMostFailures) {
    // The same configuration fails again: pausing would only hide it.
    say_(what + (has_bad_configuration ? ": its configuration is refused" : ": given up") + where);
    child.is_given_up = has_given_up_ = true;
    return;
  }
  child.early_ends = (SteadyTime() - child.started).value() < kEarly ? child.early_ends + 1 : 0;
  if (child.kept >= 0 && child.early_ends == kForgetAfter && ::ftruncate(child.kept, 0) == 0) {
    say_(fmt::format("{} starts without its former values", child.item.name));
  }
  // Everybody waits for a database: its pauses begin to grow later.
  const int doublings = std::max(0, child.failures - (child.item.is_database ? 3 : 1));
  const double pause = std::min(kLongestPause, kFirstPause * std::pow(2.0, doublings));
  child.is_due = true;
  child.next_start = SteadyTime() + Seconds(pause);
  say_(fmt::format("{}; again in {:.1f} s{}", what, pause, where));
}

std::vector<Supervisor::Report> Supervisor::Reports() const {
  std::vector<Report> reports;
  for (const Child& child : children_) {
    const char* state = child.pid > 0       ? "running"
                        : child.is_due      ? "waiting"
                        : child.is_given_up ? "given_up"
                                            : "ended";
    reports.push_back({.name = child.item.name,
                       .state = state,
                       .restarts = std::max(0, child.starts - 1),
                       .last_end = child.last_end,
                       .is_database = child.item.is_database});
  }
  return reports;
}

std::optional<std::string> Supervisor::LostVital() const {
  const auto lost = std::ranges::find_if(
      children_, [](const Child& child) { return child.is_given_up && child.item.is_vital; });
  return lost == children_.end() ? std::nullopt : std::optional(lost->item.name);
}

bool Supervisor::HasLostDatabase() const {
  return std::ranges::any_of(
      children_, [](const Child& child) { return child.is_given_up && child.item.is_database; });
}

std::string Supervisor::Status() const {
  std::string text;
  for (const Report& report : Reports()) {
    text += fmt::format("{}app={},state={},restarts={},last={},database={}",
                        text.empty() ? "" : " # ", report.name, report.state, report.restarts,
                        report.last_end, report.is_database);
  }
  return text;
}

std::optional<double> Supervisor::ResidentMib() const {
  std::optional<double> sum;
  for (const Child& child : children_) {
    const std::optional<double> resident =
        child.pid > 0 ? limpet::ResidentMib(child.pid) : std::nullopt;
    if (resident) sum = sum.value_or(0.0) + *resident;
  }
  return sum;
}

std::vector<ProcessorUsage> Supervisor::ProcessorUse() const {
  std::vector<ProcessorUsage> uses;
  for (const Child& child : children_) {
    const std::optional<Seconds> used =
        child.pid > 0 ? ProcessorTime(child.pid) : std::optional<Seconds>();
    if (used) uses.push_back({.name = child.item.name, .pid = child.pid, .used = *used});
  }
  return uses;
}

void Supervisor::EndThose(const std::function<bool(const Child&)>& which, Seconds patience) {
  const auto concerns = [&which](const Child& child) { return child.pid > 0 && which(child); };
  for (auto child = children_.rbegin(); child != children_.rend(); ++child) {
    if (concerns(*child)) {
      ::kill(child->pid, SIGTERM);
    }
  }
  const Seconds deadline = SteadyTime() + patience;
  while (std::ranges::any_of(children_, concerns) && SteadyTime() < deadline) {
    for (Child& child : children_) {
      int status = 0;
      if (child.pid > 0 && ::waitpid(child.pid, &status, WNOHANG) == child.pid) {
        child.pid = 0;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  for (Child& child : children_) {
    if (concerns(child)) {
      say_(fmt::format("{} did not end; it is killed", child.item.name));
      ::kill(child.pid, SIGKILL);
      ::waitpid(child.pid, nullptr, 0);
      child.pid = 0;
    }
  }
}

void Supervisor::End(Seconds patience) {
  End(
      patience, [](const std::string&) { return false; }, [] {});
}

void Supervisor::End(Seconds patience, const std::function<bool(const std::string&)>& is_late,
                     const std::function<void()>& between) {
  for (Child& child : children_) {
    child.is_due = false;
  }
  EndThose([&is_late](
               const Child& child) { return !child.item.is_database && !is_late(child.item.name); },
           patience);
  between();
  EndThose([](const Child& child) { return !child.item.is_database; }, patience);
  EndThose([](const Child& child) { return child.item.is_database; }, patience);
}

}  // namespace limpet
