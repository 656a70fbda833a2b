// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/message.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// A message that owns its bytes. A variable never written, or of an unknown type, reads as "".
[[nodiscard]] Message MessageFrom(const WireMessage& message);

/// Views into `message`, which must outlive them.
[[nodiscard]] WireMessage ViewOf(const Message& message);

}  // namespace limpet
