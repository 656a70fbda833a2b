// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// XXH3 of a SURVEY_AREA_REQUEST, less its own `hash=...,`.
[[nodiscard]] std::string HashOfRequest(std::string_view text);

/// The area that a SURVEY_AREA_REQUEST asks for, of a mission that surveys `now`. The error says
/// why it cannot be: it came damaged, cannot be read, or cannot be surveyed.
[[nodiscard]] Expected<SurveyArea> AreaRequested(std::string_view text, const SurveyArea& now);

}  // namespace limpet
