// SPDX-License-Identifier: MIT
#include "limpet/logbook/sync_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SyncTable::SyncTable(std::vector<std::string> names, Seconds period)
    : names_(std::move(names)), fresh_(names_.size(), kNoNumber), period_(period) {}

void SyncTable::AddColumn(const std::string& name) {
  names_.push_back(name);
  fresh_.push_back(kNoNumber);
}

void SyncTable::Update(const Message& message) {
  const auto* number = std::get_if<double>(&message.value);
  const auto found = std::ranges::find(names_, message.name);
  if (number != nullptr && found != names_.end()) {
    fresh_[static_cast<std::size_t>(found - names_.begin())] = *number;
  }
}

std::optional<SyncRow> SyncTable::TakeDueRow(Seconds since_start) {
  const double periods = std::floor(since_start.value() / period_.value());
  if (!(periods < 9e15) || static_cast<std::int64_t>(periods) <= last_row_) {
    return std::nullopt;
  }
  last_row_ = static_cast<std::int64_t>(periods);
  SyncRow row{.time = periods * period_.value(), .values = fresh_};
  std::ranges::fill(fresh_, kNoNumber);
  return row;
}

Expected<std::optional<Seconds>> ParseSyncLog(std::string_view text) {
  constexpr double kShortest = 0.1;
  const std::size_t at = text.find('@');
  const std::optional<bool> is_on = ParseFlag(Trim(text.substr(0, at)));
  const std::optional<double> period =
      at == std::string_view::npos ? 1.0 : ParseNumber(text.substr(at + 1));
  if (!is_on || !period || *period < 0.0) {
    return Error{fmt::format("`{}` is not true or false [@ seconds]", text)};
  }
  return *is_on ? std::optional<Seconds>(std::max(*period, kShortest)) : std::nullopt;
}

}  // namespace limpet
