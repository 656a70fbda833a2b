// SPDX-License-Identifier: MIT
// A SURVEY_AREA_REQUEST and the hash that it may begin with.
#pragma once

#include <string>
#include <string_view>

#include "limpet/survey/requested_area.hpp"

namespace limpet {

/// XXH3 of a SURVEY_AREA_REQUEST, less its own `hash=...,`.
[[nodiscard]] std::string HashOfRequest(std::string_view text);

/// The area that a SURVEY_AREA_REQUEST asks for. The error says why it cannot be: it came damaged,
/// or RequestedArea refuses it.
[[nodiscard]] Expected<SurveyArea> AreaRequested(std::string_view text, const AreaSetting& setting);

}  // namespace limpet
