// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/limpet/cli.hpp"

namespace limpet {

/// How to survey: options of `limpet survey` that `limpet tables` hands on to each of its runs.
[[nodiscard]] std::vector<CommandOption> SurveyMethodOptions();

/// Those of SurveyMethodOptions that were given, as words for `limpet survey`.
[[nodiscard]] std::vector<std::string> SurveyOptionsGiven(const Arguments& given);

}  // namespace limpet
