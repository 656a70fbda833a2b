// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/site/site.hpp"

namespace limpet {

/// A mission's area for a terminal. North up, as wide as `columns`: `:` ground to be seen, `.` the
/// rest of the operating region, `#` keep-out zones, `o` way points, `S` the start; under it what
/// the letters that occur mean, and its summary.
[[nodiscard]] std::string SiteText(const Site& site, int columns);

}  // namespace limpet
