// SPDX-License-Identifier: MIT
// Code in a page is cut out of a file that is compiled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per block of code that a page says to have from a file (`<!-- path -->` and, on
/// the next line, the fence) but that is not in it, line by line.
[[nodiscard]] std::vector<std::string> WronglyCited(std::string_view page,
                                                    const std::vector<SourceFile>& files);

}  // namespace limpet::layers
