// SPDX-License-Identifier: MIT
// Messages of the MOOS V10 protocol to and from bytes (docs/wire.md). Little-endian, unaligned,
// every field always present.
#pragma once

#include <optional>

#include "limpet/core/expected.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Bytes of a message whose five strings are empty.
inline constexpr std::size_t kMessageFixedSize = 54;

/// Bytes that `message` takes on the wire.
[[nodiscard]] std::size_t EncodedSize(const WireMessage& message);

/// Writes `message` to `out`, which has EncodedSize(message) bytes.
void EncodeMessage(const WireMessage& message, std::byte* out);

/// Appends `message` to `out`.
void AppendMessage(const WireMessage& message, ByteBuffer& out);

/// The first message in `bytes`, with views into them; its size is `size`. Never reads beyond
/// `bytes`, whatever lengths they claim.
struct DecodedMessage {
  WireMessage message;
  std::size_t size = 0;
};
[[nodiscard]] Expected<DecodedMessage> DecodeMessage(ByteView bytes);

}  // namespace limpet
