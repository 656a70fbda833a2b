// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace limpet {

/// One image row of linear light before the tone curve: blue, green, red planes, 0 to 4095.
using LinearRow = std::array<std::vector<float>, 3>;

}  // namespace limpet
