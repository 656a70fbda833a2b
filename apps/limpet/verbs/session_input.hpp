// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/session/saved_session.hpp"

namespace limpet {

/// The saved session that a command was given. Says on stderr if it was cut short. Throws
/// ConfigError, which names the damaged or missing file; `what` is what it is to the command.
[[nodiscard]] SavedSession OpenSession(const std::string& folder, const std::string& what);

}  // namespace limpet
