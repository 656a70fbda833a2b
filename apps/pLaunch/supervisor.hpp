// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "apps/pLaunch/launch_plan.hpp"

namespace limpet {

/// Keeps processes alive: starts them with their output in a file each, starts again what fails,
/// with pauses that grow from 0.5 s to 30 s and shrink after a minute of health, and ends them in
/// order. After `kMostFailures` failures without a minute of health it gives a process up.
/// For a database it holds a file in memory open (LIMPET_KEPT_FD), in which it finds its latest
/// values when it is started again; after `kForgetAfter` early ends in a row the file is emptied:
/// what it holds may be what it dies of.
class Supervisor {
 public:
  static constexpr int kMostFailures = 8;
  static constexpr int kForgetAfter = 3;
  using Say = std::function<void(const std::string&)>;

  /// `environment` is added to each process's own.
  Supervisor(std::filesystem::path log_folder,
             std::vector<std::pair<std::string, std::string>> environment, Say say);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  void Start(const LaunchItem& item);
  /// Notices ends and starts again what is due. False once nothing runs or is to run.
  [[nodiscard]] bool Poll();
  /// SIGTERM in reverse order of start, the database last; SIGKILL after `patience` (real time).
  void End(Seconds patience);
  /// What became of each process, as PLAUNCH_STATUS says it: `app=pNav,state=running,restarts=1,
  /// last=was killed by signal 9 (Killed),database=false # app=...`; states running, waiting (to be
  /// started again), ended, given_up.
  [[nodiscard]] std::string Status() const;
  struct Report {
    std::string name;
    const char* state = "";
    int restarts = 0;
    std::string last_end{};  ///< how it last ended; empty: it has not
    bool is_database = false;
  };
  /// The same, one by one in order of start.
  [[nodiscard]] std::vector<Report> Reports() const;
  /// True if a process was given up.
  [[nodiscard]] bool has_given_up() const { return has_given_up_; }

 private:
  struct Child {
    LaunchItem item;
    pid_t pid = 0;       ///< 0: not running
    int kept = -1;       ///< descriptor of the file in memory, of a database
    int early_ends = 0;  ///< in a row, soon after the start
    int failures = 0;
    int starts = 0;
    bool is_due = false;
    bool is_given_up = false;
    std::string last_end{};  ///< how it last ended; empty: it has not
    Seconds started, next_start;
  };
  void Launch(Child& child);
  [[noreturn]] void Become(const Child& child, pid_t parent, const char* log,
                           char* const* argv) const;
  void NoteEnd(Child& child, int status);
  void Signal(const std::function<bool(const Child&)>& which, int signal);
  void AwaitEnd(Seconds patience, bool with_database);

  std::filesystem::path log_folder_;
  std::vector<std::pair<std::string, std::string>> environment_;
  Say say_;
  std::vector<Child> children_;
  bool has_given_up_ = false;
};

}  // namespace limpet
