// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "limpet/app/heartbeat.hpp"
#include "limpet/launch/launch_plan.hpp"
#include "limpet/launch/processor_watch.hpp"

namespace limpet {

/// Keeps processes alive: starts them with their output in a file each, starts again what fails,
/// with pauses that grow from 0.5 s to 8 s and shrink after a minute of health, and ends them in
/// order. After `kMostFailures` failures without a minute of health it gives a process up.
/// For a database it holds a file in memory open (LIMPET_KEPT_FD), in which it finds its latest
/// values when it is started again; after `kForgetAfter` early ends in a row the file is emptied:
/// what it holds may be what it dies of. A process that has given signs of life (heartbeat.hpp) and
/// gives none for `LaunchItem::hung_after` hangs: it is killed and counts as failed; one that is
/// not to be watched for a while (it starts, reads, ends) gets `kPatienceUnwatched` times as long
/// unless it is halted (SIGSTOP). Those that never gave one, in no life of theirs, which are not
/// ours, are left alone but for that.
class Supervisor {
 public:
  static constexpr int kMostFailures = 8;
  static constexpr int kForgetAfter = 3;
  static constexpr double kPatienceUnwatched = 10.0;
  using Say = std::function<void(const std::string&)>;

  /// `environment` is added to each process's own.
  Supervisor(std::filesystem::path log_folder,
             std::vector<std::pair<std::string, std::string>> environment, Say say);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Each process started from now on inherits the descriptor, its number in `variable`.
  void Share(const char* variable, int descriptor) { shared_ = {variable, descriptor}; }
  void Start(const LaunchItem& item);
  /// From now on each life of the process is halted (SIGSTOP) once it has begun, or goes on.
  void Halt(const std::string& name, bool is_halted);
  /// From now on the process is dead, and not started again; or it is.
  void KeepDown(const std::string& name, bool is_down);
  /// Notices ends and starts again what is due. False once nothing runs or is to run.
  [[nodiscard]] bool Poll();
  /// SIGTERM in reverse order of start, the database last; SIGKILL after `patience` (real time).
  void End(Seconds patience);
  /// Ends all processes in two waves, each as End(patience) does: those for which `is_late` holds
  /// after the others, and after `between` was called.
  void End(Seconds patience, const std::function<bool(const std::string& name)>& is_late,
           const std::function<void()>& between);
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
  /// What became of each process, in order of start.
  [[nodiscard]] std::vector<Report> Reports() const;
  /// Memory of all processes that run [MiB]; nothing where the system does not say.
  [[nodiscard]] std::optional<double> ResidentMib() const;
  /// What each process that runs has had of the processors; those that the system does not know
  /// are left out.
  [[nodiscard]] std::vector<ProcessorUsage> ProcessorUse() const;
  /// True if a process was given up.
  [[nodiscard]] bool has_given_up() const { return has_given_up_; }
  /// Name of a process given up without which the mission cannot go on.
  [[nodiscard]] std::optional<std::string> LostVital() const;
  /// True if the database was given up: nobody hears anything any more.
  [[nodiscard]] bool HasLostDatabase() const;

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
    HeartbeatMonitor heart{};
    std::uint64_t last_beat = 0;
    Seconds silent{};         ///< since the last beat, as far as we were awake ourselves
    Seconds stopped{};        ///< how long it has been halted without a beat in this life
    bool has_beaten = false;  ///< in this life or a former one
    bool is_hung = false;
    bool is_halted = false;     ///< on demand, each life of it
    bool is_kept_down = false;  ///< on demand
  };
  [[nodiscard]] Child* Find(const std::string& name);
  /// Halts a life that has begun, if it is to be.
  static void HaltIfWanted(const Child& child);
  void Launch(Child& child);
  [[noreturn]] void Become(const Child& child, pid_t parent, const char* log,
                           char* const* argv) const;
  void NoteEnd(Child& child, int status);
  /// Kills it if it hangs. `passed`: since the last look.
  void WatchBeat(Child& child, Seconds passed);
  /// Ends those for which `which` holds.
  void EndThose(const std::function<bool(const Child&)>& which, Seconds patience);

  std::filesystem::path log_folder_;
  std::vector<std::pair<std::string, std::string>> environment_;
  struct Shared {
    const char* variable = nullptr;
    int descriptor = -1;
  } shared_;
  Say say_;
  std::vector<Child> children_;
  bool has_given_up_ = false;
  Seconds last_poll_{};  ///< steady; 0: none yet
};

}  // namespace limpet
