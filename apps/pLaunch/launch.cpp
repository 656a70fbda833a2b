// SPDX-License-Identifier: MIT
#include "apps/pLaunch/launch.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "apps/pLaunch/launch_check.hpp"
#include "apps/pLaunch/launch_plan.hpp"
#include "apps/pLaunch/launch_report.hpp"
#include "apps/pLaunch/supervisor.hpp"
#include "limpet/app/run_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/pubsub/tcp_client.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr auto kPollPeriod = std::chrono::milliseconds(50);
constexpr Seconds kStatusPeriod(5.0);  ///< a database that was started again has forgotten (real)
constexpr Seconds kPatience(8.0);      ///< for an app to finish its files
constexpr std::size_t kMostRequests = 1000;

/// What the community says of the mission's processes.
class Watch {
 public:
  Watch(const LaunchPlan& plan, std::string until)
      : until_(std::move(until)),
        client_({.host = "localhost",
                 .port = PortOf(plan),
                 .name = "pLaunch",
                 .warp = plan.warp,
                 .on_mail = [this](const WireMessage& message) { Hear(message); },
                 .on_state = nullptr}) {
    client_.Subscribe("DB_CLIENTS", Seconds(0.0));
    client_.Subscribe("DB_EVENT", Seconds(0.0));
    client_.Subscribe("APPCAST_REQ", Seconds(0.0));
    client_.Subscribe("DEPLOY", Seconds(0.0));
    if (!until_.empty()) {
      client_.Subscribe(until_, Seconds(0.0));
    }
  }
  /// Names that have come into the community since the last call.
  std::vector<std::string> TakeArrivals() {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> arrivals;
    arrivals.swap(arrivals_);
    return arrivals;
  }
  [[nodiscard]] bool IsUp(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    return up_.contains(name);
  }
  [[nodiscard]] std::set<std::string> WhoIsUp() const {
    const std::lock_guard lock(mutex_);
    return up_;
  }
  /// Texts of APPCAST_REQ since the last call.
  std::vector<std::string> TakeRequests() {
    const std::lock_guard lock(mutex_);
    return std::exchange(requests_, {});
  }
  [[nodiscard]] bool HasDatabase() const { return client_.state() == TcpClient::State::kConnected; }
  /// A new database knows nobody.
  void ForgetWhoIsUp() {
    const std::lock_guard lock(mutex_);
    up_.clear();
    knows_deploy_ = false;
  }
  /// This database has a value of DEPLOY.
  [[nodiscard]] bool knows_deploy() const { return knows_deploy_; }
  [[nodiscard]] bool has_heard_the_end() const { return has_heard_the_end_; }
  TcpClient& client() { return client_; }

 private:
  static std::uint16_t PortOf(const LaunchPlan& plan) {
    return static_cast<std::uint16_t>(
        ParseNumber(plan.mission.Global("ServerPort")).value_or(9000.0));
  }

  void Hear(const WireMessage& message) {
    knows_deploy_ = knows_deploy_ || message.key == "DEPLOY";
    if (message.key == until_) {
      has_heard_the_end_ = true;
    } else if (message.key == "APPCAST_REQ") {
      const std::lock_guard lock(mutex_);
      if (requests_.size() < kMostRequests) {
        requests_.emplace_back(message.text);
      }
    } else if (message.key == "DB_CLIENTS") {
      for (std::string_view rest = message.text; !rest.empty();) {
        const auto comma = std::min(rest.find(','), rest.size());
        Enter(std::string(rest.substr(0, comma)));
        rest.remove_prefix(std::min(comma + 1, rest.size()));
      }
    } else if (message.key == "DB_EVENT" && message.text.starts_with("connected=")) {
      Enter(std::string(message.text.substr(10)));
    } else if (message.key == "DB_EVENT" && message.text.starts_with("disconnected=")) {
      const std::lock_guard lock(mutex_);
      up_.erase(std::string(message.text.substr(13)));
    }
  }
  void Enter(const std::string& name) {
    const std::lock_guard lock(mutex_);
    if (up_.insert(name).second) {
      arrivals_.push_back(name);
    }
  }

  std::string until_;
  mutable std::mutex mutex_;
  std::set<std::string> up_;
  std::vector<std::string> arrivals_, requests_;
  std::atomic<bool> has_heard_the_end_{false}, knows_deploy_{false};
  TcpClient client_;  ///< last: its thread ends before what it writes to
};

class Launch {
 public:
  Launch(LaunchCommand command, LaunchPlan plan)
      : command_(std::move(command)),
        plan_(std::move(plan)),
        report_(plan_.mission.Global("Community"), plan_.warp),
        started_(MoosTime(plan_.warp)),
        supervisor_(RunFolder() / command_.session, Environment(), [this](const std::string& text) {
          fmt::print(stderr, "pLaunch: {}\n", text);
          report_.AddEvent(MoosTime(plan_.warp) - started_, text);
        }) {}

  int Run() {
    Say(fmt::format("{} processes, time warp {:g}, run folder {}", plan_.items.size(), plan_.warp,
                    RunFolder().string()));
    for (const LaunchItem& item : plan_.items) {
      supervisor_.Start(item);
      std::this_thread::sleep_for(std::chrono::duration<double>(plan_.between.value()));
    }
    Watch watch(plan_, command_.until);
    bool is_deployed = !command_.deploys, has_lost_database = false;
    while (!EndIsRequested() && !watch.has_heard_the_end() && supervisor_.Poll()) {
      for (const std::string& name : watch.TakeArrivals()) {
        Say(name + " is up");
      }
      if (!is_deployed && AllUp(watch)) {
        Say("all up; DEPLOY = true");
        watch.client().Publish("DEPLOY", "true");
        is_deployed = true;
      }
      if (!watch.HasDatabase()) {
        watch.ForgetWhoIsUp();
        has_lost_database = is_deployed;
      } else if (has_lost_database && AllUp(watch)) {
        has_lost_database = false;
        if (command_.deploys && !watch.knows_deploy()) {
          Say("all up again, with an empty database; DEPLOY = true");
          watch.client().Publish("DEPLOY", "true");
        }
      }
      TellStatus(watch);
      TellReport(watch);
      std::this_thread::sleep_for(kPollPeriod);
    }
    if (watch.has_heard_the_end()) {
      Say(command_.until + " was heard");
      // Apps write their last files on the same mail.
      std::this_thread::sleep_for(std::chrono::duration<double>(1.0));
    }
    Say("ending");
    supervisor_.End(kPatience);
    return supervisor_.has_given_up() ? 1 : 0;
  }

 private:
  [[nodiscard]] fs::path RunFolder() const {
    if (!command_.run_folder.empty()) {
      return command_.run_folder;
    }
    const fs::path file = fs::absolute(command_.mission_file);
    // Missions that share a folder do not share what they leave.
    const std::string part = file.stem() == "mission" ? "" : "-" + file.stem().string();
    return fs::path("runs") / (file.parent_path().filename().string() + part + "-live");
  }
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> Environment() const {
    const fs::path run = fs::absolute(RunFolder());
    return {{"LIMPET_RUN_FOLDER", (run / command_.session).string()},
            {"LIMPET_PRIOR_FOLDER",
             command_.session == "discovery" ? "" : (run / "discovery").string()},
            {"LIMPET_SESSION", command_.session},
            {"LIMPET_SEED", command_.seed}};
  }
  [[nodiscard]] bool AllUp(const Watch& watch) const {
    return std::ranges::all_of(plan_.items, [&watch](const LaunchItem& item) {
      return item.is_database || watch.IsUp(item.name);
    });
  }
  /// On every change, and now and then.
  void TellStatus(Watch& watch) {
    const Seconds now = SteadyTime();
    std::string status = supervisor_.Status();
    if (status != told_status_ || now - told_at_ >= kStatusPeriod) {
      watch.client().Publish("PLAUNCH_STATUS", status);
      told_status_ = std::move(status);
      told_at_ = now;
    }
  }
  void TellReport(Watch& watch) {
    const Seconds now = MoosTime(plan_.warp);
    for (const std::string& request : watch.TakeRequests()) {
      report_.OnRequest(request, now);
    }
    if (const auto cast = report_.Take(supervisor_.Reports(), watch.WhoIsUp(), now)) {
      watch.client().Publish("APPCAST", *cast);
    }
  }
  void Say(const std::string& text) const {
    if (!command_.is_quiet) {
      fmt::print(stderr, "pLaunch: {}\n", text);
    }
  }

  LaunchCommand command_;
  LaunchPlan plan_;
  LaunchReport report_;
  Seconds started_;  ///< MOOS time
  Supervisor supervisor_;
  std::string told_status_;
  Seconds told_at_;
};

}  // namespace

int RunLaunch(const std::string& caller, const std::vector<std::string>& args) {
  try {
    LaunchCommand command = ReadLaunchCommand(args);
    if (command.wants_help) {
      fmt::print("{}", LaunchHelp(caller));
      return 0;
    }
    LaunchPlan plan = PlanLaunch(command, fs::read_symlink("/proc/self/exe").parent_path());
    if (const int refused = RefuseToLaunch(plan.mission_file); refused != 0) {
      return refused;
    }
    CatchEndSignals();
    return Launch(std::move(command), std::move(plan)).Run();
  } catch (const ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace limpet
