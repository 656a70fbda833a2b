// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet change --session-a DIR --session-b DIR`: what changed from session A to session B, from
/// their saved frames and objects alone, as JSON. A damaged session is a ConfigError that names the
/// file.
int RunChange(std::span<const std::string> args);

}  // namespace limpet
