// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "limpet/core/message.hpp"
#include "limpet/pubsub/wildcard.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

struct TcpClientOptions {
  std::string host = "localhost";
  std::uint16_t port = 9000;
  std::string name;
  /// By the local socket of a broker on this machine, where there is one (local_socket.hpp).
  bool may_go_locally = true;
  double warp = 1.0;
  /// Takes the broker's warp from its welcome instead: for tools that are told only where it is.
  bool learns_warp = false;
  std::size_t queue = std::size_t{16} << 20;  ///< unsent mail kept, oldest lost first [bytes]
  /// Called for each piece of mail, on the client's own thread. The views die with the call.
  std::function<void(const WireMessage&)> on_mail;
  /// Called on the client's own thread whenever the state changes.
  std::function<void()> on_state;
};

/// A client of a MOOS community, ours or a stock MOOSDB: connects, and connects again with
/// back-off, registering anew each time; keeps its clock with the broker's. Writes made while
/// there is no connection wait (bounded) and are sent when there is one.
/// Thread-safe: any thread may call any function.
class TcpClient {
 public:
  enum class State { kConnecting, kConnected, kRefused };

  explicit TcpClient(TcpClientOptions options);
  ~TcpClient();
  TcpClient(const TcpClient&) = delete;
  TcpClient& operator=(const TcpClient&) = delete;

  /// Sends soon: at once if nothing was sent a moment ago, else together with what follows.
  void Publish(std::string_view name, double value, std::string_view source_aux = {});
  void Publish(std::string_view name, std::string_view value, std::string_view source_aux = {});
  void PublishValue(std::string_view name, const Value& value, std::string_view source_aux = {});
  /// Sends as it is, but for the id: a bridge keeps foreign sources, times and communities.
  void Send(WireMessage message);

  void Subscribe(const std::string& name, Seconds interval);
  void Unsubscribe(const std::string& name);
  void SubscribeWildcard(const WildcardFilter& filter);
  /// Asks the broker (ALL, VAR_SUMMARY, PROC_SUMMARY, DB_CLEAR); answers are mail with id -2.
  void Request(std::string_view what);

  [[nodiscard]] State state() const;
  /// Why the broker refused the last hello; why the last connection failed.
  [[nodiscard]] std::string trouble() const;
  /// Name of the broker's community; empty before the first welcome.
  [[nodiscard]] std::string community() const;
  /// The broker's MOOS time; never goes back.
  [[nodiscard]] Seconds Now() const;
  /// How far the broker's clock has run away from it (real time): somebody has set that clock.
  [[nodiscard]] Seconds clock_disagreement() const;
  [[nodiscard]] double warp() const;
  /// Bytes not yet handed to the system, and messages lost because there were too many.
  [[nodiscard]] std::size_t unsent() const;
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limpet
