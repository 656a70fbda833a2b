// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// Keys that MOOS gives every app; the runner reads them, apps do not.
[[nodiscard]] const std::vector<std::string>& CommonAppKeys();

}  // namespace limpet
