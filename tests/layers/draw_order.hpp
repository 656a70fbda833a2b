// SPDX-License-Identifier: MIT
// Arguments of one call that all draw: which draws first is the compiler's choice.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per call in whose parentheses more than one argument draws from a Random, by a
/// member of it or by a function that is given `random`: `path:line: call`. Two compilers make two
/// worlds of one seed then. Braces draw from left to right. Unit tests are to hold with any draw,
/// and are not read.
[[nodiscard]] std::vector<std::string> CallsThatDrawTwice(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
