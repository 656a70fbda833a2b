// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/report/paper_tables.hpp"

namespace limpet {
namespace {

/// Columns that UTF-8 text takes: continuation bytes take none.
std::size_t Width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xc0U) != 0x80U;
  }));
}

std::string Padded(const std::string& text, std::size_t width, bool is_left) {
  const std::string blanks(width > Width(text) ? width - Width(text) : 0, ' ');
  return is_left ? text + blanks : blanks + text;
}

/// Names come from missions: nothing in a table may be obeyed by a terminal or break a row.
std::vector<PaperTable> Shown(std::vector<PaperTable> tables) {
  for (PaperTable& table : tables) {
    table.title = OneLine(table.title);
    table.note = OneLine(table.note);
    for (auto& row : table.rows) {
      for (std::string& cell : row)
        cell = OneLine(cell);
    }
  }
  return tables;
}

std::vector<std::size_t> WidthsOf(const PaperTable& table) {
  std::vector<std::size_t> widths(table.header.size(), 0);
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < std::min(row.size(), widths.size()); ++i) {
      widths[i] = std::max(widths[i], Width(row[i]));
    }
  };
  widen(table.header);
  for (const auto& row : table.rows)
    widen(row);
  return widths;
}

std::string Line(const std::vector<std::string>& row, const std::vector<std::size_t>& widths) {
  std::string out = " ";
  for (std::size_t i = 0; i < row.size(); ++i)
    out += " " + Padded(row[i], widths[i], i == 0) + " ";
  while (out.ends_with(' '))
    out.pop_back();
  return out + "\n";
}

}  // namespace

std::string PlainText(const std::vector<PaperTable>& tables) {
  std::string out;
  for (const PaperTable& table : Shown(tables)) {
    const auto widths = WidthsOf(table);
    out += (out.empty() ? "" : "\n") + table.title + "\n" + Line(table.header, widths);
    for (const auto& row : table.rows)
      out += Line(row, widths);
    if (!table.note.empty()) out += "  " + table.note + "\n";
  }
  return out;
}

std::string Markdown(const std::vector<PaperTable>& tables) {
  std::string out;
  const auto line = [](const std::vector<std::string>& row) {
    return fmt::format("| {} |\n", fmt::join(row, " | "));
  };
  for (const PaperTable& table : Shown(tables)) {
    out += fmt::format("{}## {}\n\n{}|", out.empty() ? "" : "\n", table.title, line(table.header));
    for (std::size_t i = 0; i < table.header.size(); ++i)
      out += i == 0 ? " --- |" : " ---: |";
    out += "\n";
    for (const auto& row : table.rows)
      out += line(row);
    if (!table.note.empty()) out += "\n" + table.note + "\n";
  }
  return out;
}

}  // namespace limpet
