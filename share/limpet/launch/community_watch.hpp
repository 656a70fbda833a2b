// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/pubsub/tcp_client.hpp"

namespace limpet {

/// What the community says of the mission's processes and of the mission. Its own thread listens;
/// any thread may ask.
class CommunityWatch {
 public:
  struct Settings {
    std::uint16_t port = 9000;
    double warp = 1.0;
    std::string until;  ///< variable to listen for; empty: none
  };
  explicit CommunityWatch(const Settings& settings);

  /// A variable's latest value, when we heard it (steady time) and how often.
  struct Heard {
    std::string text{};
    double number = 0.0;
    bool is_number = false;
    std::string source{};
    Seconds at{};
    int times = 0;
  };
  /// Listens for one more.
  void Listen(const std::string& variable) { client_.Subscribe(variable, Seconds(0.0)); }
  [[nodiscard]] std::optional<Heard> Latest(const std::string& variable) const;
  /// Latest text of the variable; empty if it was not heard.
  [[nodiscard]] std::string TextOf(const std::string& variable) const;

  /// Names that have come into the community since the last call.
  [[nodiscard]] std::vector<std::string> TakeArrivals();
  /// Texts of APPCAST_REQ since the last call.
  [[nodiscard]] std::vector<std::string> TakeRequests();
  [[nodiscard]] bool IsUp(const std::string& name) const;
  [[nodiscard]] std::set<std::string> WhoIsUp() const;
  /// True if its <APP>_STATUS says that it hears `variable`, or everything.
  [[nodiscard]] bool Hears(const std::string& name, const std::string& variable) const;

  [[nodiscard]] bool HasDatabase() const { return client_.state() == TcpClient::State::kConnected; }
  /// A new database knows nobody, and perhaps nothing.
  void ForgetDatabase();
  [[nodiscard]] bool has_heard_the_end() const;
  TcpClient& client() { return client_; }

 private:
  void Hear(const WireMessage& message);
  void Enter(const std::string& name);

  std::string until_;
  mutable std::mutex mutex_;
  std::set<std::string> up_;
  std::vector<std::string> arrivals_, requests_;
  std::map<std::string, Heard> latest_;
  TcpClient client_;  ///< last: its thread ends before what it writes to
};

}  // namespace limpet
