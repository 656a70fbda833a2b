// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "estimation/replay/csv_fields.hpp"
#include "limpet/core/harmless_text.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

/// What a topic of ROS as CSV begins with.
inline constexpr std::string_view kRosCsvHeader = "%time,";

/// Columns of a header: which one has which name.
class RosColumns {
 public:
  /// Throws BadLine.
  explicit RosColumns(std::string_view header) {
    if (!header.starts_with(kRosCsvHeader)) throw BadLine{"does not begin with `%time,`"};
    const CsvFields fields(header);
    if (fields.size() > kMostColumns) {
      throw BadLine{fmt::format("has {} columns; {} are the most", fields.size(), kMostColumns)};
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
      names_.push_back(HarmlessText(fields.Text(i)));
  }
  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const std::string& Name(std::size_t column) const { return names_[column]; }
  [[nodiscard]] std::optional<std::size_t> Find(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    return found == names_.end() ? std::nullopt
                                 : std::optional<std::size_t>(found - names_.begin());
  }
  /// The columns `base0`, `base1`, ...; nothing if one of them lacks.
  template <std::size_t kCount>
  [[nodiscard]] std::optional<std::array<std::size_t, kCount>> FindAll(
      std::string_view base) const {
    std::array<std::size_t, kCount> columns{};
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto column = Find(fmt::format("{}{}", base, i));
      if (!column) return std::nullopt;
      columns[i] = *column;
    }
    return columns;
  }
  /// The first few names, for messages.
  [[nodiscard]] std::string Listed() const {
    constexpr std::size_t kShown = 6;
    std::string list;
    for (std::size_t i = 1; i < std::min(names_.size(), kShown + 1); ++i)
      list += (i > 1 ? ", " : "") + names_[i];
    return list + (names_.size() > kShown + 1 ? ", ..." : "");
  }

 private:
  static constexpr std::size_t kMostColumns = 1000;
  std::vector<std::string> names_;
};

/// A row whose values may be asked for. Throws BadLine, which names the column.
class RosRow {
 public:
  RosRow(const RosColumns& columns, std::string_view line) : columns_(columns), fields_(line) {
    if (fields_.size() != columns.size()) {
      throw BadLine{fmt::format("has {} columns, its header {}", fields_.size(), columns.size())};
    }
  }
  /// Nothing of what is no finite number, as `nan` is.
  [[nodiscard]] std::optional<double> Number(std::size_t column) const {
    double value = 0.0;
    try {
      value = fields_.Number(column);
    } catch (const BadLine&) {
      throw BadLine{fmt::format("column {} is `{}`, not a number", columns_.Name(column),
                                HarmlessText(fields_.Text(column)))};
    }
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  [[nodiscard]] bool Flag(std::size_t column) const { return Number(column).value_or(0.0) > 0.0; }
  /// Time in seconds of a column in nanoseconds; the text is a whole number, of more digits than a
  /// double has.
  [[nodiscard]] double Stamp(std::size_t column) const {
    const auto nanoseconds = ParseInteger(fields_.Text(column));
    if (!nanoseconds) {
      throw BadLine{fmt::format("column {} is `{}`, not a time in nanoseconds",
                                columns_.Name(column), HarmlessText(fields_.Text(column)))};
    }
    return 1e-9 * static_cast<double>(*nanoseconds);
  }

 private:
  const RosColumns& columns_;
  CsvFields fields_;
};

}  // namespace limpet
