// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/sharing/share_address.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Who sent a datagram (IPv4).
struct UdpPeer {
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  [[nodiscard]] std::string Text() const;
};

/// The sockets of pShare. Listening and name resolution have a thread of their own; what has come
/// is kept, bounded for each input, until somebody takes it. Sending never blocks.
class UdpSockets {
 public:
  using Input = std::size_t;
  static constexpr std::size_t kQueuePerInput = std::size_t{2} << 20;  ///< [bytes]
  static constexpr std::size_t kMostInputs = 64;
  /// What comes back to where Send sends from, as if it were an input.
  static constexpr Input kReplies = kMostInputs;

  struct Datagram {
    Input input = 0;
    UdpPeer sender;
    ByteBuffer bytes;
  };

  /// `on_arrival` is called, on the sockets' thread, when there is something to take.
  explicit UdpSockets(std::function<void()> on_arrival);
  ~UdpSockets();
  UdpSockets(const UdpSockets&) = delete;
  UdpSockets& operator=(const UdpSockets&) = delete;

  /// Listens at the address's port of `interface` (an IPv4 address; 0.0.0.0: all), in its group if
  /// it is a multicast channel.
  [[nodiscard]] Expected<Input> Listen(const ShareAddress& address, const std::string& interface);
  /// The port that the system chose, if the address said 0.
  [[nodiscard]] std::uint16_t PortOf(Input input) const;

  /// Starts to look up a host, and keeps looking until it is found. Sending to it waits for that.
  void Resolve(const ShareAddress& address);
  /// Hands one datagram to the system; why not, if it did not.
  [[nodiscard]] std::optional<Error> Send(const ShareAddress& address, ByteView bytes);

  /// Hands one datagram back to whom one came from, from where it came to. Lost if the system does
  /// not take it.
  void Reply(const Datagram& to, ByteView bytes);

  /// What has come since the last call, in order.
  [[nodiscard]] std::vector<Datagram> Take();
  /// Datagrams lost because nobody took them in time.
  [[nodiscard]] std::uint64_t overflow() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limpet
