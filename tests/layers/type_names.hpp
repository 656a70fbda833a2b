// SPDX-License-Identifier: MIT
// One name, one type: the linker takes either of two definitions for both, and says nothing.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per type of a namespace that two headers define, or a header and a .cpp file
/// outside of its unnamed namespace: `name: path, path`.
[[nodiscard]] std::vector<std::string> TypesDefinedTwice(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
