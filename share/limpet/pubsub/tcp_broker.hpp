// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "limpet/pubsub/broker.hpp"

namespace limpet {

struct TcpBrokerOptions {
  BrokerOptions broker;
  std::string bind_address = "127.0.0.1";  ///< loopback unless the mission says otherwise
  std::uint16_t port = 9000;               ///< 0: any free one
  double warp = 1.0;
  Seconds client_timeout{5.0};     ///< silence after which a client is dropped (real time)
  Seconds handshake_timeout{5.0};  ///< from connection to hello (real time)
  Seconds stuck_timeout{10.0};     ///< a client that reads nothing with mail waiting is cut
  /// Connections that have not yet said who they are; with one more, the oldest of them goes.
  std::size_t handshakes = 256;
  bool may_send_together = true;  ///< false: as on a system without io_uring (send_batch.hpp)
  /// A file that outlives the broker: what it holds is taken over, latest values are kept there
  /// (value_keeper.hpp). -1: none.
  int kept_descriptor = -1;
  std::size_t kept = std::size_t{8} << 20;  ///< room for them [bytes]
  /// Asked twice a second (real time) for variables to write in the broker's own name.
  using Words = std::vector<std::pair<std::string, std::string>>;
  std::function<Words(const Broker& broker, Seconds now)> report{};
};

/// The broker on TCP, and on a local socket beside it when it listens on loopback: one thread, no
/// call that blocks, so a silent or hostile connection delays nobody. Mail is pushed as soon as the
/// bytes that caused it are worked off.
class TcpBroker {
 public:
  /// Binds and listens. Throws std::runtime_error naming address and port if it cannot.
  explicit TcpBroker(TcpBrokerOptions options);
  ~TcpBroker();
  TcpBroker(const TcpBroker&) = delete;
  TcpBroker& operator=(const TcpBroker&) = delete;

  /// Serves until Stop().
  void Run();
  /// Ends Run(). May be called from any thread.
  void Stop();
  [[nodiscard]] std::uint16_t port() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limpet
