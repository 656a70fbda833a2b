// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/site/site.hpp"

namespace limpet {

/// A mission's area as SVG, north up.
[[nodiscard]] std::string SiteSvg(const Site& site);

}  // namespace limpet
