// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <sys/types.h>

#include "limpet/core/units.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/topics/simulation.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {

/// The basin mission without camera and map, as real processes under pLaunch: what a dive needs.
/// It aligns for a second, dives to 3 m, and comes home at once when told to.
class LiveMission {
 public:
  /// `run_options`: process name to options of its Run line; `block_lines`: to lines of its block.
  using Lines = std::map<std::string, std::string>;
  explicit LiveMission(const Lines& run_options = {}, const Lines& block_lines = {});
  ~LiveMission();
  LiveMission(const LiveMission&) = delete;
  LiveMission& operator=(const LiveMission&) = delete;

  /// More lines of its scenario; before the launch.
  void AppendToScenario(const std::string& lines) const;
  /// Starts pLaunch with --deploy and these options.
  void Launch(const std::string& option = "--until=MISSION_END");
  /// Text of a variable as last heard; numbers as text. Empty: not heard.
  [[nodiscard]] std::string Latest(const std::string& variable) const;
  [[nodiscard]] std::string SourceOf(const std::string& variable) const;
  [[nodiscard]] std::optional<SimThrust> Thrust() const;
  /// True once `holds`; false after a minute. Notes how late this machine lets us wake.
  bool Await(const std::function<bool()>& holds);
  /// Worst so far in Await: how much later than asked for this process was woken (real time).
  [[nodiscard]] Seconds lateness() const { return lateness_; }
  void ForgetLateness() { lateness_ = Seconds(0.0); }
  /// Waits until the vehicle dives with thrust.
  bool AwaitDive();
  void Poke(const std::string& variable, const std::string& value) {
    client_->Publish(variable, value);
  }
  /// MOOS time of the community.
  [[nodiscard]] Seconds Now() const { return client_->Now(); }
  /// Process of that name, started by the launcher; 0: none.
  [[nodiscard]] pid_t PidOf(const std::string& process) const;
  [[nodiscard]] pid_t launcher() const { return launcher_; }
  /// Waits for the launcher to end; its exit code, -1 if it does not end within a minute.
  int AwaitEnd();
  /// What pLaunch has said.
  [[nodiscard]] std::string Said() const;
  [[nodiscard]] std::filesystem::path run_folder() const { return folder_.path() / "run"; }

 private:
  struct Heard {
    std::string text, source;
  };
  TemporaryFolder folder_;
  std::uint16_t port_ = FreePort();
  pid_t launcher_ = 0;
  Seconds lateness_{};
  mutable std::mutex mutex_;
  std::map<std::string, Heard> heard_;
  std::unique_ptr<TcpClient> client_;  ///< last: its thread ends first
};

}  // namespace limpet
