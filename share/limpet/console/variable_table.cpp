// SPDX-License-Identifier: MIT
#include "limpet/console/variable_table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "limpet/core/letter_case.hpp"
#include "limpet/pubsub/wildcard.hpp"
#include "limpet/pubsub/wildcard_list.hpp"

namespace limpet {
namespace {

bool MatchesTyped(const std::string& typed, const std::string& name) {
  std::istringstream words(UpperCase(typed));
  const std::string upper = UpperCase(name);
  bool has_word = false;
  for (std::string word; words >> word; has_word = true) {
    const bool is_pattern = word.find_first_of("*?") != std::string::npos;
    if (is_pattern ? MatchesWildcard(word, upper) : upper.find(word) != std::string::npos) {
      return true;
    }
  }
  return !has_word;
}

/// A rate to six percent; 1, 2, 5 and their decades lie well inside a step.
double SeenRate(double hz) { return hz > 0.0 ? std::round(12.0 * std::log2(hz)) : -1e9; }

}  // namespace

double VariableRow::RateAt(Seconds now) const {
  return rate.events() >= 2 ? rate.At(now) : told_rate;
}

bool VariableRow::IsOverdue(Seconds now) const {
  constexpr double kLatePeriods = 5.0;
  constexpr std::uint64_t kRegular = 5;  // writes
  const double hz = rate.At(written);
  return writes >= kRegular && hz > 0.0 && Age(now).value() > kLatePeriods / hz;
}

void VariableTable::Hear(const Message& message, Seconds heard) {
  const auto [position, is_new] = rows_.try_emplace(message.name);
  VariableRow& row = position->second;
  // What the broker only repeats, as it does on registration, has no id; nor has its own news.
  const bool is_latched = message.id < 0 && (is_new || message.time == row.stamp);
  // A clock elsewhere may be wrong; what comes live is written now.
  const Seconds written = is_latched ? std::min(message.time, heard) : heard;
  if (is_latched && !is_new) {
    return;
  }
  KeptValue value = KeptValue::Of(message.value);
  const bool is_change = !is_new && row.value != value;
  if (is_new) {
    row.name = message.name;
  }
  if (is_new || is_change) {
    row.changed = written;
  }
  row.changes += is_change ? 1 : 0;
  if (!is_latched) {
    ++row.writes;
    row.rate.Note(heard);
  }
  row.history.push_back({written, value.Shortened(kHistoryBytes), message.source});
  if (row.history.size() > kMostHistory) {
    row.history.pop_front();
  }
  row.value = std::move(value);
  row.source = message.source;
  row.source_aux = message.source_aux;
  row.community = message.community;
  row.stamp = message.time;
  row.written = written;
}

void VariableTable::HearRate(const std::string& name, double hz) {
  if (const auto found = rows_.find(name); found != rows_.end()) {
    found->second.told_rate = hz;
  }
}

const VariableRow* VariableTable::Find(const std::string& name) const {
  const auto found = rows_.find(name);
  return found == rows_.end() ? nullptr : &found->second;
}

const char* NameOf(ScopeSort sort) {
  switch (sort) {
    case ScopeSort::kAge:
      return "age";
    case ScopeSort::kRate:
      return "rate";
    case ScopeSort::kSource:
      return "source";
    default:
      return "name";
  }
}

bool ScopeFilter::Accepts(const VariableRow& row) const {
  return IsChosen(names, row.name) && IsChosen(sources, row.source) &&
         MatchesTyped(typed, row.name) && (!changed_only || row.changes > 0);
}

std::vector<const VariableRow*> Arranged(const VariableTable& table, const ScopeFilter& filter,
                                         ScopeSort sort, bool is_reversed, Seconds now) {
  std::vector<const VariableRow*> rows;
  for (const auto& [name, row] : table.rows()) {
    if (filter.Accepts(row)) {
      rows.push_back(&row);
    }
  }
  // Rows come by name, and a stable sort keeps that among equals: what differs by less than a
  // person can see must not dance.
  if (sort == ScopeSort::kAge) {
    std::ranges::stable_sort(rows, {},
                             [now](const auto* row) { return std::floor(row->Age(now).value()); });
  } else if (sort == ScopeSort::kRate) {
    std::ranges::stable_sort(rows, std::greater{},
                             [now](const auto* row) { return SeenRate(row->RateAt(now)); });
  } else if (sort == ScopeSort::kSource) {
    std::ranges::stable_sort(rows, {}, [](const auto* row) { return row->source; });
  }
  if (is_reversed) {
    std::ranges::reverse(rows);
  }
  return rows;
}

}  // namespace limpet
