// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "limpet/core/units.hpp"
#include "limpet/pubsub/outbox.hpp"
#include "limpet/pubsub/outgoing_packet.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// What a client has to say: messages wait (bounded), are gathered into packets, and go out as the
/// socket takes them. A packet that a lost connection cut short goes out whole on the next one: the
/// broker never understood it. Not thread-safe.
class ClientSender {
 public:
  enum class Outcome { kAllSent, kBlocked, kFailed };

  /// `queue`: bytes that may wait; the oldest are lost first.
  explicit ClientSender(std::size_t queue) : outbox_(queue) {}

  void Queue(const WireMessage& message);
  /// A new connection begins: its first packet leads with the time.
  void Restart();
  /// Sends until all is sent or the socket takes no more. `now`: MOOS time of this client, for the
  /// timing message that leads a packet each second and keeps the connection alive.
  [[nodiscard]] Outcome Send(int descriptor, Seconds now);
  /// Frees room that a burst has left, if nothing waits.
  void GiveBack();

  /// A packet is on its way, part of it unsent.
  [[nodiscard]] bool is_in_packet() const { return packet_.unsent() > 0; }
  /// Bytes not yet handed to the system.
  [[nodiscard]] std::size_t waiting() const { return outbox_.size() + packet_.unsent(); }
  [[nodiscard]] std::uint64_t dropped() const { return outbox_.dropped(); }
  /// Steady time of the last attempt to send.
  [[nodiscard]] Seconds last_send() const { return last_send_; }

 private:
  [[nodiscard]] bool Assemble(Seconds now);
  [[nodiscard]] ssize_t SendSome(int descriptor) const;

  Outbox outbox_;
  ByteBuffer encoded_;
  OutgoingPacket packet_;
  Seconds last_send_, last_timing_;
};

}  // namespace limpet
