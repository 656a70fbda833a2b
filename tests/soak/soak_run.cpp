// SPDX-License-Identifier: MIT
#include "tests/soak/soak_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/simulation.hpp"
#include "tests/soak/process_samples.hpp"
#include "tests/support/free_port.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr Seconds kSoakNap(0.1);         ///< between two looks, and two pings
constexpr Seconds kSampleEvery(1.0);     ///< of memory and descriptors
constexpr Seconds kFirstHit(5.0);        ///< all is up by then
constexpr Seconds kPatienceOfEnd(60.0);  ///< of a launcher that is told to end
constexpr double kAtSurface_m = 0.5;
constexpr const char* kPing = "SOAK_PING";

/// Starts a program with its output in a file.
pid_t Start(const std::vector<std::string>& words, const fs::path& output) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  std::vector<char*> argv;
  for (const std::string& word : words) {
    argv.push_back(const_cast<char*>(word.c_str()));  // NOLINT(*-const-cast): as execv has it
  }
  argv.push_back(nullptr);
  ::execv(argv.front(), argv.data());
  ::_exit(127);
}

int CodeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

/// One line of `faults:`, drawn.
std::string DrawnFault(const SoakPlan& plan, Random& random) {
  constexpr std::array kPhases{"ALIGN", "DIVE", "SURVEY", "RETURN", "ASCEND"};
  const double lasts = random.Uniform(5.0, 60.0), at = random.Uniform(0.0, 60.0);
  const std::string_view phase = kPhases.at(random.Index(kPhases.size()));
  return fmt::format("{{what: {}, when: SURVEY_PHASE = {}, at_s: {:.0f}, for_s: {:.0f}}}",
                     plan.fault.at(random.Index(plan.fault.size())), phase, at, lasts);
}

/// A copy of the mission with drawn faults and the plan's camera; says the faults.
std::string PrepareMission(const SoakPlan& plan, const fs::path& source, const fs::path& copy,
                           Random& random) {
  fs::copy(source, copy, fs::copy_options::recursive);
  const fs::path file = copy / "scenario.yaml";
  if (!LoadScenario(file).faults.empty()) {
    throw std::runtime_error(fmt::format("{}: has faults of its own", file.string()));
  }
  std::ifstream in(file);
  std::string text, faults;
  for (std::string line; std::getline(in, line);) {
    text += (line.starts_with("camera:") ? "camera: " + plan.camera : line) + "\n";
  }
  for (int i = 0; i < plan.faults_per_run; ++i) {
    faults += (i == 0 ? "faults:\n  - " : "  - ") + DrawnFault(plan, random) + "\n";
  }
  std::ofstream(file) << text << faults;
  return faults;
}

/// What the community says, heard on the client's own thread.
class SoakEar {
 public:
  void Hear(const WireMessage& mail, SoakRun& run) {
    const std::scoped_lock lock(mutex_);
    if (mail.key == kPing) {
      if (mail.number > last_ping_) {  // one that a new database has kept comes twice
        last_ping_ = mail.number;
        run.round_trips_ms.push_back(1e3 * (SteadyTime().value() - mail.number));
      }
    } else if (mail.key == topics::kMissionEnd.name) {
      run.ended = std::string(mail.text);
    } else if (mail.key == topics::kSimTruth.name) {
      if (const auto truth = TopicCodec<SimTruth>::Decode(std::string(mail.text))) {
        run.down_m = truth->down;
      }
    }
  }

 private:
  std::mutex mutex_;
  double last_ping_ = 0.0;
};

/// Hits processes of a launcher, and keeps the account of all of them.
class Hitter {
 public:
  Hitter(const SoakPlan& plan, pid_t launcher, Random& random)
      : plan_(plan), launcher_(launcher), random_(random), next_hit_(SteadyTime() + kFirstHit) {
    DrawNext();
  }
  void Look(SoakRun& run) {
    const Seconds now = SteadyTime();
    if (now < next_look_) return;
    next_look_ = now + kSampleEvery;
    const std::vector<SampledProcess> children = ChildrenOf(launcher_);
    for (const SampledProcess& child : children) {
      Note(child, now, run);
    }
    const bool hits = plan_.kill_every > Seconds(0.0) && now >= next_hit_ && !children.empty();
    if (!hits) return;
    Hit(children.at(random_.Index(children.size())), now, run);
    DrawNext();
  }

 private:
  void DrawNext() {
    next_hit_ += Seconds(-plan_.kill_every.value() * std::log(1.0 - random_.Uniform(0.0, 0.99)));
  }
  void Note(const SampledProcess& child, Seconds now, SoakRun& run) {
    ProcessLife& life = run.lives[child.pid];
    if (life.times_s.empty()) {
      born_[child.pid] = now;
      if (const auto killed = killed_.find(child.name); killed != killed_.end()) {
        run.restarts_s[child.name].push_back((now - killed->second).value());
        killed_.erase(killed);
      }
    }
    life.name = child.name;
    life.times_s.push_back((now - born_[child.pid]).value());
    life.resident_mib.push_back(child.resident_mib);
    life.descriptors.push_back(child.descriptors);
  }
  void Hit(const SampledProcess& victim, Seconds now, SoakRun& run) {
    const bool stops = random_.Chance(plan_.stop_share);
    if (::kill(victim.pid, stops ? SIGSTOP : SIGKILL) != 0) return;
    ++(stops ? run.stops : run.kills)[victim.name];
    if (!stops) killed_[victim.name] = now;
  }

  const SoakPlan& plan_;
  pid_t launcher_;
  Random& random_;
  Seconds next_hit_, next_look_{};
  std::map<pid_t, Seconds> born_;
  std::map<std::string, Seconds> killed_;
};

/// Until the launcher has ended; how, as waitpid says it.
int WatchToTheEnd(const SoakPlan& plan, pid_t launcher, TcpClient& client, Random& random,
                  SoakRun& run) {
  Hitter hitter(plan, launcher, random);
  const Seconds begin = SteadyTime();
  Seconds deadline = begin + plan.run_longest;
  int status = 0;
  while (::waitpid(launcher, &status, WNOHANG) != launcher) {
    if (SteadyTime() > deadline) {
      ::kill(launcher, run.was_cut ? SIGKILL : SIGTERM);
      run.was_cut = true;
      deadline = SteadyTime() + kPatienceOfEnd;
    }
    if (!run.was_cut) hitter.Look(run);
    client.Publish(kPing, SteadyTime().value());
    std::this_thread::sleep_for(std::chrono::duration<double>(kSoakNap.value()));
  }
  run.real_s = (SteadyTime() - begin).value();
  return status;
}

void ReadLogs(const SoakPlaces& places, const fs::path& folder, SoakRun& run) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".alog") continue;
    ++run.logs;
    int status = 0;
    const pid_t scan =
        Start({(places.programs / "limpet").string(), "log", "scan", entry.path().string()},
              folder / "scan.out");
    if (::waitpid(scan, &status, 0) != scan || CodeOf(status) != 0) ++run.unreadable_logs;
  }
}

}  // namespace

std::string SoakRun::Complaint() const {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  if (was_cut) add("it took too long");
  if (ended.empty()) add("its end was not said");
  if (!down_m) add("nobody said where the vehicle was");
  if (down_m && *down_m > kAtSurface_m) add(fmt::format("ended {:.1f} m deep", *down_m));
  if (unreadable_logs > 0) add(fmt::format("{} logs cannot be read", unreadable_logs));
  if (logs == 0) add("there is no log");
  return text;
}

SoakRun RunOnce(const SoakPlan& plan, const SoakPlaces& places, int seed, Random& random) {
  SoakRun run;
  run.seed = seed;
  const fs::path folder = places.scratch / fmt::format("run_{}", seed);
  fs::create_directories(folder);
  run.faults = PrepareMission(plan, places.source / plan.mission, folder / "mission", random);
  const std::uint16_t port = FreePort();
  const pid_t launcher =
      Start({(places.programs / "limpet").string(), "launch", (folder / "mission").string(),
             fmt::format("--MOOSTimeWarp={:g}", plan.warp), "--deploy", "--until=MISSION_END",
             "--run_folder=" + (folder / "run").string(), fmt::format("--seed={}", seed),
             fmt::format("--ServerPort={}", port)},
            folder / "launch.out");
  {
    SoakEar ear;
    TcpClientOptions options;
    options.port = port;
    options.name = "soak";
    options.warp = plan.warp;
    options.on_mail = [&](const WireMessage& mail) { ear.Hear(mail, run); };
    TcpClient client(options);
    client.Subscribe(kPing, Seconds(0.0));
    client.Subscribe(topics::kMissionEnd.name, Seconds(0.0));
    client.Subscribe(topics::kSimTruth.name, Seconds(0.2));
    run.exit_code = CodeOf(WatchToTheEnd(plan, launcher, client, random, run));
  }
  if (fs::exists(folder / "run")) ReadLogs(places, folder / "run", run);
  return run;
}

}  // namespace limpet
