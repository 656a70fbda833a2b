// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {

/// Depths and objects of session B beside those of session A, as JSON: objects as `limpet change`
/// judges them. The error names the file that is damaged; throws ConfigError as CompareSessions.
[[nodiscard]] Expected<std::string> MapDiffJson(const SavedSession& a, const SavedSession& b);
/// What MapDiffJson says, in words for people.
[[nodiscard]] Expected<std::string> MapDiffText(const SavedSession& a, const SavedSession& b);

}  // namespace limpet
