// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/mission/source_text.hpp"

namespace limpet {

/// Prepares the lines of a behavior file for parsing: comments go, a trailing backslash joins the
/// next line, lines are trimmed, and braces that open a line or a `{` that ends one stand alone.
/// Blank lines stay: one of them ends a mode declaration. A `}` at the end of other text is not
/// split off, as in MOOS-IvP.
[[nodiscard]] std::vector<TextLine> BehaviorLines(const std::vector<TextLine>& lines);

}  // namespace limpet
