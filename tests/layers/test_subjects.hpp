// SPDX-License-Identifier: MIT
// Tests mirror the tree: who changes a file finds its test by its name.
#pragma once

#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One complaint per file `tests/unit/<library>/<name>_test.cpp` whose name does not begin with the
/// name of a file of that library (or of tests/support), and is not what such a file's name begins
/// with: `navigator_session_tie_test` is of `navigator`, `alog_test` of `alog_reader` and its kin.
/// A folder inside a library counts as the last word: `pose_factors_test` is of `factors/`. What is
/// of a library as a whole begins with the library's name: `replay_honesty_test`.
[[nodiscard]] std::vector<std::string> TestsWithoutSubject(const std::vector<SourceFile>& files);

}  // namespace limpet::layers
