// SPDX-License-Identifier: MIT
// Tests mirror the tree: who changes a file finds its test by its name.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per file `tests/unit/<library>/<name>_test.cpp` whose name neither is the name of
/// a source file of that library, of a folder in it or of tests/support, nor begins with one and
/// `_`: `packet_codec_test` and `packet_codec_captures_test` are of `packet_codec`, `packet_test`
/// is not.
[[nodiscard]] std::vector<std::string> TestsWithoutSubject(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
