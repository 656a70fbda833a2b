// SPDX-License-Identifier: MIT
// Configuration text as lines that remember where they came from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// One line without its line end.
struct TextLine {
  std::string text;
  SourceLine where;
};

/// Splits at line feeds; a carriage return before one goes too. A last line without an end counts,
/// an empty one does not.
[[nodiscard]] std::vector<TextLine> SplitLines(std::string_view text, const std::string& file);

/// The whole file. Throws ConfigError if it cannot be read.
[[nodiscard]] std::string ReadTextFile(const std::filesystem::path& file);

}  // namespace limpet
