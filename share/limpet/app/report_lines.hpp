// SPDX-License-Identifier: MIT
// The body of an app's report, laid out for terminals of 80 columns.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// A table with a head, a rule, and columns as wide as their widest cell.
class ReportTable {
 public:
  /// A head that begins with `>` makes a column of numbers: aligned to the right.
  ReportTable(std::initializer_list<std::string_view> heads);

  /// Cells that are missing stay empty; more than there are columns are left out.
  void AddRow(std::vector<std::string> cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::vector<std::string> Lines() const;

 private:
  struct Column {
    std::string head;
    bool is_number = false;
  };
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

class ReportLines {
 public:
  static constexpr std::size_t kWidth = 78;  ///< longer lines are cut, and end in `..`

  void Add(std::string_view line);
  void Blank() { Add(""); }
  /// `Name:       value`, values in one column.
  void Pair(std::string_view name, std::string_view value);
  void Add(const ReportTable& table);
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  /// The lines, each with its line feed, for tests and terminals.
  [[nodiscard]] std::string Text() const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace limpet
