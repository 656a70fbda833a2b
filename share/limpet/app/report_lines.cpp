// SPDX-License-Identifier: MIT
#include "limpet/app/report_lines.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {

ReportTable::ReportTable(std::initializer_list<std::string_view> heads) {
  for (const std::string_view head : heads) {
    const bool is_number = head.starts_with('>');
    columns_.push_back({std::string(head.substr(is_number ? 1 : 0)), is_number});
  }
}

void ReportTable::AddRow(std::vector<std::string> cells) {
  cells.resize(columns_.size());
  rows_.push_back(std::move(cells));
}

std::vector<std::string> ReportTable::Lines() const {
  std::vector<std::string> lines(rows_.size() + 2);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    std::size_t width = column.head.size();
    for (const std::vector<std::string>& row : rows_) {
      width = std::max(width, row[i].size());
    }
    const auto put = [&](std::string& line, std::string_view cell) {
      line += column.is_number ? fmt::format("  {:>{}}", cell, width)
                               : fmt::format("  {:<{}}", cell, width);
    };
    put(lines[0], column.head);
    lines[1] += "  " + std::string(width, '-');
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      put(lines[r + 2], rows_[r][i]);
    }
  }
  for (std::string& line : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
  }
  return lines;
}

void ReportLines::Add(std::string_view line) {
  if (line.size() <= kWidth) {
    lines_.emplace_back(line);
  } else {
    lines_.push_back(std::string(line.substr(0, kWidth - 2)) + "..");
  }
}

void ReportLines::Pair(std::string_view name, std::string_view value) {
  Add(fmt::format("{:<14}{}", fmt::format("{}:", name), value));
}

void ReportLines::Add(const ReportTable& table) {
  for (const std::string& line : table.Lines()) {
    Add(line);
  }
}

std::string ReportLines::Text() const {
  std::string text;
  for (const std::string& line : lines_) {
    text += line + "\n";
  }
  return text;
}

}  // namespace limpet
