// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/limpet/cli.hpp"

namespace limpet {

/// How to survey: options of `limpet survey` that `limpet tables` hands on to each of its runs.
[[nodiscard]] std::vector<CommandOption> SurveyMethodOptions();

}  // namespace limpet
