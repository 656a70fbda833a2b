// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace limpet {

/// What is missing in a log, or may be: messages and rows.
struct LogLosses {
  std::uint64_t dropped = 0;   ///< the disk did not take them
  std::uint64_t in_doubt = 0;  ///< written, but a sync failed: a disk may have lost them
  std::uint64_t waiting = 0;   ///< for a disk that takes nothing now

  LogLosses& operator+=(const LogLosses& other) {
    dropped += other.dropped;
    in_doubt += other.in_doubt;
    waiting += other.waiting;
    return *this;
  }
};

}  // namespace limpet
