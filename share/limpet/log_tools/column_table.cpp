// SPDX-License-Identifier: MIT
#include "limpet/log_tools/column_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/console/frame.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/require.hpp"

namespace limpet {

void ColumnTable::Add(std::vector<std::string> cells) {
  LIMPET_REQUIRE(cells.size() == columns_.size(), "a cell per column");
  for (std::string& cell : cells) {
    cell = OneLine(cell);  // for people's eyes, wherever it goes
  }
  rows_.push_back(std::move(cells));
}

std::string ColumnTable::Text(bool has_colours) const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    widths.push_back(ColumnsOf(columns_[i].head));
    for (const auto& row : rows_) {
      widths[i] = std::max(widths[i], ColumnsOf(row[i]));
    }
  }
  const auto line = [&](const auto& cell_of) {
    std::string text;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      text += i == 0 ? "" : "  ";
      text += columns_[i].is_right ? fmt::format("{:>{}}", cell_of(i), widths[i])
                                   : fmt::format("{:<{}}", cell_of(i), widths[i]);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1);
  };
  const std::string head = line([this](std::size_t i) { return columns_[i].head; });
  std::string text = has_colours ? "\033[1m" + head + "\033[0m\n" : head + "\n";
  for (const auto& row : rows_) {
    text += line([&row](std::size_t i) { return row[i]; }) + "\n";
  }
  return text;
}

bool HasColours() { return isatty(STDOUT_FILENO) != 0 && ColorsAreWanted(); }

std::string BytesText(double bytes) {
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 999.5 && unit + 1 < kUnits.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return unit == 0 || bytes >= 99.95 ? fmt::format("{:.0f} {}", bytes, kUnits[unit])
                                     : fmt::format("{:.1f} {}", bytes, kUnits[unit]);
}

std::string CountText(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) {
    text.insert(at - 3, " ");
  }
  return text;
}

}  // namespace limpet
