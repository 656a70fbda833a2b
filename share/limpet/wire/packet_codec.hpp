// SPDX-License-Identifier: MIT
// Packets: what is framed on a MOOS TCP connection (docs/wire.md).
#pragma once

#include "limpet/core/expected.hpp"
#include "limpet/wire/message_codec.hpp"

namespace limpet {

/// The bytes that a client sends before its first packet.
inline constexpr std::string_view kGreeting{"ELKS CAN'T DANCE 2/8/10\0\0\0\0\0\0\0\0\0", 32};

/// True if the text up to the first NUL is the greeting's, ignoring case.
/// REQUIRES: as many bytes as kGreeting has.
[[nodiscard]] bool IsGreeting(ByteView bytes);

inline constexpr std::size_t kPacketHeaderSize = 9;
inline constexpr std::size_t kMaxPacketSize = std::size_t{64} << 20;

struct PacketHeader {
  std::size_t size = 0;   ///< of the whole packet, this header included
  std::size_t count = 0;  ///< of its messages
};

/// Size and count, refused when they cannot be true: before anything is allocated for them.
/// REQUIRES: kPacketHeaderSize bytes.
[[nodiscard]] Expected<PacketHeader> DecodePacketHeader(ByteView bytes,
                                                        std::size_t max_size = kMaxPacketSize);

/// Writes a header at `out`.
void EncodePacketHeader(const PacketHeader& header, std::byte* out);

/// Walks the messages of one whole packet.
class PacketReader {
 public:
  /// `packet` has all bytes that its (valid) header claims.
  explicit PacketReader(ByteView packet);
  [[nodiscard]] bool is_at_end() const { return left_ == 0 && rest_.empty(); }
  /// The next message; an error ends the packet. REQUIRES: !is_at_end().
  [[nodiscard]] Expected<WireMessage> Next();
  /// The bytes of the message that Next() gave last.
  [[nodiscard]] ByteView raw() const { return raw_; }

 private:
  ByteView rest_;
  ByteView raw_;
  std::size_t left_ = 0;
};

/// A packet of one message.
[[nodiscard]] ByteBuffer PacketOf(const WireMessage& message);

}  // namespace limpet
