// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// Turns entries into rows of a CSV table: the time, then a column per variable.
class AlogCsv {
 public:
  enum class Join {
    kNone,  ///< a row per entry, with its own cell alone
    kLast,  ///< a row per instant, with the last value of every column
  };
  AlogCsv(std::vector<std::string> columns, Join join);

  void AppendHeader(std::string& out) const;
  /// Appends the rows that `entry` completes.
  void Append(std::string& out, const AlogEntry& entry);
  /// Appends what is still open; the last call.
  void AppendRest(std::string& out);
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  void AppendRow(std::string& out, double time);

  std::vector<std::string> columns_;
  std::vector<std::string> cells_;  ///< as they will stand in the row
  Join join_;
  std::optional<double> open_time_;  ///< of the row being gathered
  std::uint64_t rows_ = 0;
};

/// Quoted if it holds what would end a CSV field.
[[nodiscard]] std::string CsvField(std::string_view text);

}  // namespace limpet
