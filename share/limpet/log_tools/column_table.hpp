// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limpet {

/// A table for a terminal: columns as wide as their widest cell, the head bold where there are
/// colours. Plain text otherwise.
class ColumnTable {
 public:
  struct Column {
    std::string head;
    bool is_right = true;  ///< numbers stand to the right
  };
  explicit ColumnTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// REQUIRES: one cell per column.
  void Add(std::vector<std::string> cells);
  [[nodiscard]] bool is_empty() const { return rows_.empty(); }
  [[nodiscard]] std::string Text(bool has_colours) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// True if stdout is a terminal that may be coloured (NO_COLOR is not set).
[[nodiscard]] bool HasColours();

/// `12.3 MB`, `840 B`.
[[nodiscard]] std::string BytesText(double bytes);
/// `1 234 567`.
[[nodiscard]] std::string CountText(std::uint64_t count);

}  // namespace limpet
