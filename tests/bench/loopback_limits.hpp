// SPDX-License-Identifier: MIT
// What the machine's loopback sockets can do without any broker: the limit beside which the
// broker's figures mean something. Blocking sockets, one thread for each reader, no protocol.
#pragma once

#include <cstddef>

namespace limpet {

enum class SocketKind { kTcp, kLocal };

/// Of one hop from a writer to `readers` threads: p50 and p99 of the last one's delay [us].
struct HopDelay {
  double p50 = 0.0, p99 = 0.0;
};
[[nodiscard]] HopDelay LoopbackHop(SocketKind kind, int readers, int count, double hz);

/// Median of going there and back at once, over and over, 80 bytes each way [us].
[[nodiscard]] double LoopbackRoundTrip(SocketKind kind, int count);

/// Bytes per second through one socket in blocks of `block` bytes.
[[nodiscard]] double LoopbackThroughput(SocketKind kind, std::size_t block, double seconds);

}  // namespace limpet
