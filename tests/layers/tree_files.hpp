// SPDX-License-Identifier: MIT
// The tree that the tests of this folder read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// Empty if it cannot be read.
[[nodiscard]] std::string ReadAll(const std::filesystem::path& file);
/// Every C++ file of the product and its tests.
[[nodiscard]] std::vector<SourceFile> TreeFiles();

}  // namespace limpet::layers
