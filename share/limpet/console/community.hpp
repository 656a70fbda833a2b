// SPDX-License-Identifier: MIT
// A tool's way into a community: where it is, and a connection that never hangs.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "limpet/console/command.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/pubsub/tcp_client.hpp"

namespace limpet {

/// Where a community is, as the command line and the mission file say.
struct CommunityAddress {
  std::string host = "localhost";
  std::uint16_t port = 9000;
  std::optional<MissionFile> mission{};
  Seconds wait{};         ///< how long to try to join one that is not there yet (real time)
  Seconds patience{5.0};  ///< for an answer (real time)
  std::string name{};     ///< to join under; empty: the tool's own

  [[nodiscard]] std::string Text() const;
};

/// Options that AddressOf understands, for a Command; `with` are the tool's own.
[[nodiscard]] std::vector<CommandOption> WithAddressOptions(std::vector<CommandOption> with);
/// `.moos`, `.moos++`, or a folder that holds a mission.moos.
[[nodiscard]] bool IsMissionName(const std::string& word);
/// What the options say wins over the mission's ServerHost and ServerPort. Throws UsageError,
/// ConfigError.
[[nodiscard]] CommunityAddress AddressOf(const Arguments& given,
                                         const std::optional<std::string>& mission);

/// Nobody answers, or not as a database does; the text names host and port and says what to do.
class NoCommunity : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A message and when it came, on the community's clock.
struct Mail {
  Message message;
  Seconds heard;
};

/// A connection of a tool. The warp is learned from the broker. Mail arrives on another thread
/// and waits here, bounded; all calls come from one thread.
class Community {
 public:
  /// Joins as `name`, or as the address says. Throws NoCommunity.
  Community(const CommunityAddress& address, const std::string& name);

  [[nodiscard]] TcpClient& client() { return *client_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Seconds Now() const { return client_->Now(); }
  /// Subscribes to what matches, also if that is one name: unlike a plain registration it creates
  /// no variable.
  void Watch(const std::string& pattern);
  /// All mail since the last call; waits up to `wait` (real time) if there is none.
  [[nodiscard]] std::vector<Mail> TakeMail(Seconds wait = Seconds(0.0));
  /// All mail up to the broker's answer to a question put now: what was asked for before has then
  /// been answered. Nothing if it does not answer in time, or a signal ends the wait.
  [[nodiscard]] std::optional<std::vector<Mail>> Settle();
  /// Messages lost because they were not taken in time.
  [[nodiscard]] std::uint64_t lost() const;

 private:
  void Add(const WireMessage& message);
  void Join();

  CommunityAddress address_;
  std::string name_;
  mutable std::mutex mutex_;
  std::condition_variable arrival_;
  std::vector<Mail> inbox_;
  std::size_t inbox_bytes_ = 0;
  std::uint64_t lost_ = 0;
  std::unique_ptr<TcpClient> client_;  ///< last: its thread ends before what it writes to
};

/// A name that no other tool on this machine has: `uScope_4711`.
[[nodiscard]] std::string OwnName(const std::string& tool);

}  // namespace limpet
