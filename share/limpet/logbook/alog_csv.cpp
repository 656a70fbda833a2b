// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_csv.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace limpet {

std::string CsvField(std::string_view text) {
  const bool is_plain = text.find_first_of(",\"\r\n") == std::string_view::npos &&
                        !text.starts_with(' ') && !text.ends_with(' ');
  if (is_plain) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + "\"";
}

AlogCsv::AlogCsv(std::vector<std::string> columns, Join join)
    : columns_(std::move(columns)), cells_(columns_.size()), join_(join) {}

void AlogCsv::AppendHeader(std::string& out) const {
  out += "time";
  for (const std::string& column : columns_) {
    out += ',' + CsvField(column);
  }
  out += '\n';
}

void AlogCsv::Append(std::string& out, const AlogEntry& entry) {
  const auto found = std::ranges::find(columns_, entry.name);
  if (found == columns_.end()) {
    return;
  }
  if (open_time_ && (join_ == Join::kNone || *open_time_ != entry.time)) {
    AppendRow(out, *open_time_);
  }
  open_time_ = entry.time;
  cells_[static_cast<std::size_t>(found - columns_.begin())] =
      entry.number ? std::string(entry.value) : CsvField(entry.value);
}

void AlogCsv::AppendRest(std::string& out) {
  if (open_time_) {
    AppendRow(out, *open_time_);
    open_time_.reset();
  }
}

void AlogCsv::AppendRow(std::string& out, double time) {
  fmt::format_to(std::back_inserter(out), "{:.5f}", time);
  for (std::string& cell : cells_) {
    out += ',';
    out += cell;
    if (join_ == Join::kNone) {
      cell.clear();
    }
  }
  out += '\n';
  ++rows_;
}

}  // namespace limpet
