// SPDX-License-Identifier: MIT
// One shared value: a bare message of the MOOS protocol, one per datagram (docs/wire.md).
#pragma once

#include "limpet/core/expected.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// MOOS's pShare sends nothing larger.
inline constexpr std::size_t kLargestShare = std::size_t{48} << 10;

/// The bytes that share `message`; an error if they are too many.
[[nodiscard]] Expected<ByteBuffer> EncodeShare(const WireMessage& message);

/// The one message of a datagram, with views into it. Refused: what is no whole message, or more
/// than one; what is no write; names that no variable or app has; times that are no number.
[[nodiscard]] Expected<WireMessage> DecodeShare(ByteView datagram);

}  // namespace limpet
