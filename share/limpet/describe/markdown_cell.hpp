// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// Text that stays inside one cell of a Markdown table.
[[nodiscard]] inline std::string MarkdownCell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

}  // namespace limpet
