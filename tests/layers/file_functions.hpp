// SPDX-License-Identifier: MIT
// Functions that a file keeps to itself: in a batch of files the compiler sees those of them all.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per function that the unnamed namespaces of two .cpp files of one library (or of
/// one program of tests) define, or one such and a header: `folder/name: file file`. Compiled in
/// one batch, another file's may be the better overload, and is then called without a word.
[[nodiscard]] std::vector<std::string> FunctionsOfTwoFiles(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
