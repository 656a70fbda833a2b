// SPDX-License-Identifier: MIT
// Parts of what `limpet change` prints.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limpet/comparison/session_comparison.hpp"

namespace limpet {

[[nodiscard]] nlohmann::ordered_json JsonOf(const StatusPosterior& posterior);
[[nodiscard]] nlohmann::ordered_json JsonOf(const SessionFacts& facts);
[[nodiscard]] nlohmann::ordered_json JsonOf(const SessionComparison& comparison);

}  // namespace limpet
