// SPDX-License-Identifier: MIT
// Inside of TcpClient: what it says (tcp_client.cpp), and its connection
// (tcp_client_connection.cpp).
#pragma once

#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "limpet/pubsub/client_clock.hpp"
#include "limpet/pubsub/client_sender.hpp"
#include "limpet/pubsub/local_socket.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/pubsub/unit_reader.hpp"

namespace limpet {

/// Any thread may call what is public before UnitSize; the rest is of the client's own thread.
class TcpClient::Impl {
 public:
  explicit Impl(TcpClientOptions options);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Sends the message as it is, but for the id.
  void Send(WireMessage message);
  /// Sends the message as this client's own, stamped now.
  void Post(WireMessage message, std::string_view source_aux);
  void Subscribe(const std::string& name, Seconds interval);
  void Unsubscribe(const std::string& name);
  void SubscribeWildcard(const WildcardFilter& filter);
  void Request(std::string_view what);

  [[nodiscard]] State state() const;
  [[nodiscard]] std::string trouble() const;
  [[nodiscard]] std::string community() const;
  [[nodiscard]] std::size_t unsent() const;
  [[nodiscard]] std::uint64_t dropped() const;
  [[nodiscard]] double warp() const { return clock_.warp(); }
  [[nodiscard]] Seconds Now() const { return clock_.Now(); }
  [[nodiscard]] Seconds clock_disagreement() const { return clock_.disagreement(); }

  // What UnitReader asks of its reader.
  [[nodiscard]] Expected<std::optional<std::size_t>> UnitSize(ByteView bytes) const;
  [[nodiscard]] bool OnUnit(ByteView unit);
  /// The broker is trusted with this process's memory, up to the largest packet.
  [[nodiscard]] static RoomKind MayHold(std::size_t, std::size_t) { return RoomKind::kHeap; }

 private:
  void Connect();
  void Reach(const asio::ip::tcp::resolver::results_type& places);
  void Greet();
  void WaitToRead();
  /// Takes the answer to the hello. False: it is a refusal.
  bool Enter(const WireMessage& answer);
  void Retry(const std::string& why);
  /// Keeps the connection alive while there is nothing to say.
  void Idle();
  void TellState();

  // With mutex_ held:
  void SendSubscription(const std::string& name, Seconds interval);
  void SendFilter(const WildcardFilter& filter);
  void Control(WireMessage message);
  /// Sends at once if nothing was sent a moment ago, else together with what follows.
  void Queue(const WireMessage& message);
  void Flush();
  void WaitToWrite();

  TcpClientOptions options_;
  ClientClock clock_;
  mutable std::mutex mutex_;  ///< guards all down to `descriptor_`
  State state_ = State::kConnecting;
  std::string trouble_, community_;
  ClientSender sender_;
  std::map<std::string, Seconds> subscriptions_;
  std::vector<WildcardFilter> filters_;
  std::int32_t next_id_ = 0;
  bool is_flush_due_ = false;
  bool is_leaving_ = false;
  int descriptor_ = -1;

  // The client's own thread alone.
  asio::io_context context_;
  StreamSocket socket_;
  asio::ip::tcp::resolver resolver_;
  asio::steady_timer timer_;  ///< of the next attempt, or of leaving
  asio::steady_timer keep_alive_;
  UnitReader reader_;
  ByteBuffer scratch_;
  bool is_welcome_ = false;
  std::string refusal_;  ///< of the hello just sent
  double retry_;         ///< pause before the next attempt [s], real time
  std::thread thread_;
};

}  // namespace limpet
