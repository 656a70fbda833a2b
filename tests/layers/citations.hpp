// SPDX-License-Identifier: MIT
// Works that comments cite, `[Kuhn 1955]`, have an entry in docs/references.md.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// Names of the page's entries, which begin with `- **[Name year]**`: "Kuhn 1955".
[[nodiscard]] std::set<std::string> ReadReferences(std::string_view markdown);

/// Works that the comments of a file cite, in order: `[Name year]` or `[Name year, where in it]`,
/// also where a line ends within.
[[nodiscard]] std::vector<std::string> CitationsIn(const SourceFile& file);

/// One complaint per citation in a comment that is no entry of `references`.
[[nodiscard]] std::vector<std::string> CitationsWithoutEntry(
    const std::vector<SourceFile>& files, const std::set<std::string>& references);

}  // namespace limpet::layers
