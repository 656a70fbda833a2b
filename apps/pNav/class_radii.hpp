// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Believed radius [m] per class, as a block says it: `yellow:0.5, orange:0.3`, or `none`.
[[nodiscard]] Expected<std::map<std::string, double>> ParseClassRadii(std::string_view text);

}  // namespace limpet
