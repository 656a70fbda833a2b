// SPDX-License-Identifier: MIT
// What a saved session's map holds.
#pragma once

#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {

/// What is known of the session's map, as JSON. The error names the file that is damaged.
[[nodiscard]] Expected<std::string> MapInfoJson(const SavedSession& session);
/// What MapInfoJson says, in words for people.
[[nodiscard]] Expected<std::string> MapInfoText(const SavedSession& session);

}  // namespace limpet
