// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// The run at one glance: objects, where, how sure, status against the truth, coverage, navigation,
/// speed. Aligned columns of at most 100 characters; `has_color` adds ANSI colours.
[[nodiscard]] std::string TerminalReport(const RunScore& run, bool has_color);

/// Writes the report to `out`, in colour when that is a terminal and NO_COLOR is not set.
void PrintReport(const RunScore& run, std::FILE* out = stdout);

}  // namespace limpet
