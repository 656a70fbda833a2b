// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace limpet {

/// As this machine calls itself; nothing if it does not say.
[[nodiscard]] std::optional<std::string> HostName();

}  // namespace limpet
