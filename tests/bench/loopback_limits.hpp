// SPDX-License-Identifier: MIT
// What the machine's loopback sockets can do without any broker: the limit beside which the
// broker's figures mean something. Blocking sockets, one thread for each reader, no protocol.
#pragma once

#include <cstddef>

namespace limpet {

/// Of one hop from a writer to `readers` threads: p50 and p99 of the last one's delay [us].
struct HopDelay {
  double p50 = 0.0, p99 = 0.0;
};
[[nodiscard]] HopDelay LoopbackHop(int readers, int count, double hz);

/// Bytes per second through one socket in blocks of `block` bytes.
[[nodiscard]] double LoopbackThroughput(std::size_t block, double seconds);

}  // namespace limpet
