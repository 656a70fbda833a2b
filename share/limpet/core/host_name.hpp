// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace limpet {

/// Name that this machine calls itself by; nothing if it does not say.
[[nodiscard]] std::optional<std::string> HostName();

}  // namespace limpet
