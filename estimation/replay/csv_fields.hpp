// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet {

/// A line that cannot be understood.
struct BadLine {
  std::string why;
};

/// The fields of one line; numbers by column. Points into the line. Throws BadLine.
class CsvFields {
 public:
  explicit CsvFields(std::string_view line) {
    for (std::size_t start = 0; start <= line.size();) {
      const std::size_t comma = std::min(line.find(',', start), line.size());
      fields_.push_back(Trim(line.substr(start, comma - start)));
      start = comma + 1;
    }
  }
  [[nodiscard]] std::string_view kind() const { return fields_.front(); }
  [[nodiscard]] std::size_t size() const { return fields_.size(); }
  void Expect(std::size_t columns) const {
    if (fields_.size() != columns) {
      throw BadLine{fmt::format("{} has {} columns, not {}", kind(), fields_.size(), columns)};
    }
  }
  /// nan and inf are read as they are; who uses them must check.
  [[nodiscard]] double Number(std::size_t i) const {
    const std::string_view text = i < fields_.size() ? fields_[i] : std::string_view();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw BadLine{fmt::format("column {} of {} is `{}`, not a number", i + 1, kind(), text)};
    }
    return value;
  }
  [[nodiscard]] int Integer(std::size_t i) const {
    const double value = Number(i);
    if (value != std::floor(value) || std::abs(value) > 2e9) {
      throw BadLine{fmt::format("column {} of {} is not a whole number", i + 1, kind())};
    }
    return static_cast<int>(value);
  }
  [[nodiscard]] std::optional<double> Optional(std::size_t i) const {
    return i < fields_.size() && fields_[i].empty() ? std::nullopt
                                                    : std::optional<double>(Number(i));
  }
  [[nodiscard]] std::string Text(std::size_t i) const {
    return i < fields_.size() ? std::string(fields_[i]) : std::string();
  }
  [[nodiscard]] bool AreFinite(std::size_t first) const {
    for (std::size_t i = first; i < fields_.size(); ++i) {
      if (!fields_[i].empty() && !std::isfinite(Number(i))) return false;
    }
    return true;
  }

 private:
  std::vector<std::string_view> fields_;
};

}  // namespace limpet
