// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "limpet/pubsub/parcel.hpp"

namespace limpet {

/// A packet on its way into a socket, of which part may be there already. It is put together in
/// three steps: Begin(), messages into `lead` and mail into `mail`, Seal(). Its room is used again.
class OutgoingPacket {
 public:
  OutgoingPacket() = default;
  /// Bytes to be sent as they are.
  explicit OutgoingPacket(ByteBuffer bytes) : lead(std::move(bytes)) {}

  /// Empties it, with room for a header.
  void Begin();
  /// Writes the header. A short packet becomes a single piece, cheaper to send than two.
  void Seal(std::size_t messages);
  void Clear();
  /// Frees room that a burst has left. REQUIRES: unsent() == 0.
  void GiveBack();

  /// Memory that nobody else holds [bytes].
  [[nodiscard]] std::size_t own() const { return lead.size() + mail.own(); }
  [[nodiscard]] std::size_t unsent() const { return lead.size() + mail.size() - sent_; }
  /// What is unsent, as pieces for a gathering write; gives how many of `pieces` it filled. They
  /// may end before the packet does.
  [[nodiscard]] std::size_t Gather(std::span<ByteView> pieces) const;
  /// The socket took that many more bytes.
  void Took(std::size_t bytes) { sent_ += bytes; }
  /// Nothing of it has reached anybody: all is to be sent, to another socket.
  void Rewind() { sent_ = 0; }
  /// Frees mail that is sent; after this it cannot be rewound.
  void ForgetSent();

  ByteBuffer lead;  ///< header, and messages that do not come from a queue
  Parcel mail;

 private:
  std::size_t sent_ = 0;
};

}  // namespace limpet
