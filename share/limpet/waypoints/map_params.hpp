// SPDX-License-Identifier: MIT
// Parameters of existing missions that are no plain numbers, declared alike by all behaviors.
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/shapes/shape.hpp"
#include "limpet/shapes/visual_hints.hpp"

namespace limpet {

/// The name of a variable without blanks; empty: not posted.
void DescribeVariable(ParamCollector& visit, const char* name, std::string& field,
                      const char* help);
/// `visual_hints`, one or more lines.
void DescribeHints(ParamCollector& visit, VisualHints& hints);
/// `post_suffix`: appended to status variables, after an underscore.
void DescribeSuffix(ParamCollector& visit, const char* name, std::string& suffix);

}  // namespace limpet
