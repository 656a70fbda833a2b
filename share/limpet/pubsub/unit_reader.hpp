// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include <asio/buffer.hpp>

#include "limpet/core/expected.hpp"
#include "limpet/pubsub/local_socket.hpp"
#include "limpet/pubsub/receive_buffer.hpp"
#include "limpet/wire/packet_codec.hpp"

namespace limpet {

/// Cuts what a non-blocking socket gives into whole units (greeting, packets). Bytes land in a
/// buffer that all connections share; only a unit that has not arrived whole is kept, in room that
/// grows with what has really come, whatever its header claims.
///
/// `Protocol` offers
///   Expected<std::optional<std::size_t>> UnitSize(ByteView) const;  // nothing: more bytes needed
///   bool OnUnit(ByteView);                                          // false: close
///   RoomKind MayHold(std::size_t now, std::size_t then);  // memory for what is unfinished
class UnitReader {
 public:
  enum class End {
    kDrained,  ///< the socket is empty
    kMore,     ///< the budget is used up
    kStarved,  ///< no room for the rest of a unit
    kClosed,   ///< the connection is to be closed
  };

  /// Bytes of memory kept for a unit that has not arrived whole.
  [[nodiscard]] std::size_t held() const { return partial_.capacity(); }
  [[nodiscard]] bool is_amid() const { return !partial_.empty(); }
  /// Bytes of it that are there, and that it takes in all, if its header says.
  [[nodiscard]] std::size_t arrived() const { return partial_.bytes().size(); }
  template <class Protocol>
  [[nodiscard]] std::size_t Announced(const Protocol& protocol) const {
    const auto size = protocol.UnitSize(partial_.bytes());
    return size ? (*size).value_or(0) : 0;
  }

  /// Where the next bytes are to be read to; `scratch` must be its caller's alone until Take.
  /// Nothing: the connection is to be closed. No byte: there is no room for the rest.
  template <class Protocol>
  [[nodiscard]] std::optional<std::span<std::byte>> Room(std::span<std::byte> scratch,
                                                         Protocol& protocol) {
    if (partial_.empty()) {
      return scratch;
    }
    const auto size = protocol.UnitSize(partial_.bytes());
    if (!size) {
      return std::nullopt;
    }
    // The rest of this unit and no more: what follows it belongs in the shared buffer.
    const std::size_t held = partial_.bytes().size();
    const std::size_t wanted = (*size).value_or(kPacketHeaderSize);
    if (const std::size_t kept = std::min(wanted, partial_.capacity()); kept > held) {
      return partial_.RoomUpTo(kept, RoomKind::kHeap);
    }
    const std::size_t grown = std::min(wanted, 2 * held + scratch.size());
    const RoomKind kind = protocol.MayHold(partial_.capacity(), grown);
    return kind == RoomKind::kNone ? std::span<std::byte>() : partial_.RoomUpTo(grown, kind);
  }

  /// Works off the `read` part of Room(). False if the connection is to be closed.
  template <class Protocol>
  [[nodiscard]] bool Take(ByteView read, Protocol& protocol) {
    return partial_.empty() ? Cut(read, protocol) : Complete(read.size(), protocol);
  }

  /// Reads until the socket is empty or `budget` bytes are worked off; `received` counts them.
  template <class Protocol>
  [[nodiscard]] End Read(StreamSocket& socket, std::span<std::byte> scratch, std::size_t budget,
                         Protocol& protocol, std::size_t& received) {
    received = 0;
    while (received < budget) {
      const auto room = Room(scratch, protocol);
      if (!room) {
        return End::kClosed;
      }
      if (room->empty()) {
        return End::kStarved;
      }
      std::error_code error;
      const std::size_t wanted = std::min(room->size(), budget - received);
      const std::size_t count = socket.read_some(asio::mutable_buffer(room->data(), wanted), error);
      if (error == asio::error::would_block) {
        return End::kDrained;
      }
      if (error) {
        return End::kClosed;
      }
      received += count;
      const bool was_partial = !partial_.empty();
      if (!Take(room->first(count), protocol)) {
        return End::kClosed;
      }
      if (!was_partial && partial_.empty() && count < wanted) {
        return End::kDrained;  // asking again would only be told so
      }
    }
    return End::kMore;
  }

 private:
  /// Works off every whole unit in `bytes` and keeps the rest.
  template <class Protocol>
  bool Cut(ByteView bytes, Protocol& protocol) {
    while (!bytes.empty()) {
      const auto size = protocol.UnitSize(bytes);
      if (!size) {
        return false;
      }
      if (!*size || **size > bytes.size()) {
        partial_.Append(bytes);
        return true;
      }
      if (!protocol.OnUnit(bytes.first(**size))) {
        return false;
      }
      bytes = bytes.subspan(**size);
    }
    return true;
  }

  template <class Protocol>
  bool Complete(std::size_t count, Protocol& protocol) {
    partial_.Grew(count);
    const auto size = protocol.UnitSize(partial_.bytes());
    if (!size) {
      return false;
    }
    if (*size && **size == partial_.bytes().size()) {
      const bool is_good = protocol.OnUnit(partial_.bytes());
      partial_.Clear();
      return is_good;
    }
    return true;
  }

  ReceiveBuffer partial_;
};

}  // namespace limpet
