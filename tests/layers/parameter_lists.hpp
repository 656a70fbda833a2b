// SPDX-License-Identifier: MIT
// Arguments that a caller can exchange without the compiler's noticing.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per function of the product that takes several numbers in a row which all are
/// plain doubles: two of one that a header declares, three of one that a file keeps to itself:
/// `path: Name(parameters)`. A struct, a vector or a unit says which is which.
[[nodiscard]] std::vector<std::string> InterchangeableNumbers(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
