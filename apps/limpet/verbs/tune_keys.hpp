// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/tuning/report_expression.hpp"

namespace limpet {

/// The complaint about a key of `expression` that no report of these sessions can have, whatever
/// happens in them, with the nearest that one has. What lies below a list, or below what may be
/// null, only a report tells.
[[nodiscard]] std::optional<std::string> ImpossibleKey(const ReportExpression& expression,
                                                       const std::vector<std::string>& sessions);

}  // namespace limpet
