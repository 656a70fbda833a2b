// SPDX-License-Identifier: MIT
// Tables of Markdown, read back.
#pragma once

#include <string>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// Cells of a row of a Markdown table, `\|` undone.
inline std::vector<std::string> MarkdownCells(const std::string& row) {
  std::vector<std::string> cells(1);
  for (std::size_t i = 1; i + 1 < row.size(); ++i) {
    if (row[i] == '\\' && row[i + 1] == '|') {
      cells.back() += row[++i];
    } else if (row[i] == '|') {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  for (std::string& cell : cells)
    cell = std::string(Trim(cell));
  return cells;
}

inline std::vector<std::vector<std::string>> RowsOf(const std::string& page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : Split(page, '\n')) {
    if (line.starts_with("| `")) rows.push_back(MarkdownCells(line));
  }
  return rows;
}

}  // namespace limpet
