// SPDX-License-Identifier: MIT
// A broker on TCP listens on a local (Unix) socket as well: a program on the same machine then
// talks to it for half the processor time. Its name is made from the TCP address, so whoever knows
// that knows it; it lives in the abstract namespace and dies with the broker, however that ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <asio/generic/stream_protocol.hpp>
#include <asio/ip/address.hpp>
#include <asio/local/stream_protocol.hpp>

namespace limpet {

/// A connected stream, TCP or local: from here on there is no difference.
using StreamSocket = asio::generic::stream_protocol::socket;

/// Where a broker that listens on `address` and `port` is to be found by programs of its machine;
/// nothing if it does not listen on loopback. All addresses (0.0.0.0) include 127.0.0.1.
[[nodiscard]] std::optional<asio::local::stream_protocol::endpoint> LocalPlaceOf(
    const asio::ip::address& address, std::uint16_t port);

/// Connected to the broker that listens on that loopback address and port; nothing if there is
/// none, or if it is another machine's, another user's (but root's), or no Limpet.
[[nodiscard]] std::optional<StreamSocket> ConnectLocally(
    const StreamSocket::executor_type& executor, const asio::ip::address& address,
    std::uint16_t port);

/// Gives a local socket as much room to send as a TCP one takes under load.
void WidenLocal(StreamSocket& socket);

}  // namespace limpet
