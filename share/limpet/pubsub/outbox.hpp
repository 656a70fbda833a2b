// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "limpet/pubsub/parcel.hpp"
#include "limpet/pubsub/router.hpp"

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
  void Append(Router::Variable variable, const SharedBytes& message);
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Bytes queued.
  [[nodiscard]] std::size_t size() const { return parcel_.size(); }
  /// Bytes taken earlier that still wait for the socket; they count against the limit. `own`: of
  /// them, those that nobody else holds.
  void SetInFlight(std::size_t bytes, std::size_t own = 0) {
    in_flight_ = bytes;
    own_in_flight_ = own;
  }
  /// Memory that nobody else holds, queued or in flight [bytes].
  [[nodiscard]] std::size_t own() const {
    return parcel_.own() + own_in_flight_ + entries_.capacity() * sizeof(Entry);
  }
  /// Loses the older half of what is queued, at least one message.
  void DropOlderHalf();
  [[nodiscard]] std::size_t in_flight() const { return in_flight_; }
  /// Messages lost for want of room, ever.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

  /// Takes everything into `parcel` (whose room is used again); gives the number of messages.
  std::size_t Take(Parcel& parcel);
  /// Forgets everything queued.
  void Clear();
  /// Frees room that a burst has left, if nothing is queued.
  void GiveBack();

 private:
  struct Entry {
    Router::Variable variable;
    std::uint32_t size;
  };
  void Enter(Router::Variable variable, std::size_t size);
  void MakeRoom(Router::Variable variable, std::size_t size);
  void Compact();

  std::size_t limit_;
  std::size_t in_flight_ = 0, own_in_flight_ = 0;
  std::uint64_t dropped_ = 0;
  Parcel parcel_;
  std::vector<Entry> entries_;  ///< one for each message of the parcel
};

}  // namespace limpet
