// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "limpet/pubsub/router.hpp"
#include "limpet/wire/packet_codec.hpp"

namespace limpet {

/// Encoded mail that waits for one client, bounded in bytes. When it is full, the oldest mail of
/// the variable that has news goes first, then the oldest of all: what a slow reader gets is late
/// values, not none. Making room frees an eighth at once, so that a full queue stays cheap.
class Outbox {
 public:
  static constexpr Router::Variable kNoVariable = UINT32_MAX;  ///< of answers to requests

  explicit Outbox(std::size_t limit) : limit_(limit) {}

  /// Queues one encoded message. A message larger than the limit is queued alone.
  void Append(Router::Variable variable, ByteView message);
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Bytes queued.
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  /// Bytes taken earlier that still wait for the socket; they count against the limit.
  void SetInFlight(std::size_t bytes) { in_flight_ = bytes; }
  [[nodiscard]] std::size_t in_flight() const { return in_flight_; }
  /// Messages lost for want of room, ever.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

  /// Takes everything, back to back, into `body` (whose capacity is used again); gives the number
  /// of messages.
  std::size_t Take(ByteBuffer& body);
  /// Forgets everything queued.
  void Clear();

 private:
  struct Entry {
    Router::Variable variable;
    std::uint32_t size;
  };
  void MakeRoom(Router::Variable variable, std::size_t size);
  void Compact();

  std::size_t limit_;
  std::size_t in_flight_ = 0;
  std::uint64_t dropped_ = 0;
  ByteBuffer bytes_;
  std::vector<Entry> entries_;
};

}  // namespace limpet
