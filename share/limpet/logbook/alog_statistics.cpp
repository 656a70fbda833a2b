// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {

void NumberStatistics::Add(double value) {
  if (count == 0) {
    least = greatest = first = value;
  }
  ++count;
  least = std::min(least, value);
  greatest = std::max(greatest, value);
  last = value;
  const double deviation = value - mean;
  mean += deviation / static_cast<double>(count);
  square_sum += deviation * (value - mean);
}

double NumberStatistics::StandardDeviation() const {
  return count == 0 ? 0.0 : std::sqrt(square_sum / static_cast<double>(count));
}

double VariableStatistics::Rate() const {
  return last > first ? static_cast<double>(entries - 1) / (last - first) : 0.0;
}

VariableStatistics& AlogStatistics::Of(std::string_view name) {
  const auto found = variables_.find(name);
  if (found != variables_.end()) {
    return found->second;
  }
  VariableStatistics& created = variables_[std::string(name)];
  created.name = std::string(name);
  return created;
}

void AlogStatistics::Add(const AlogLine& line, const AlogEntry& entry) {
  bytes_ += line.text.size() + 1;
  if (line.kind != AlogLine::Kind::kEntry) {
    return;
  }
  if (entries_++ == 0) {
    first_ = last_ = entry.time;
  }
  out_of_order_ += entry.time < last_ ? 1 : 0;
  first_ = std::min(first_, entry.time);
  last_ = std::max(last_, entry.time);
  VariableStatistics& variable = Of(entry.name);
  if (variable.entries++ == 0) {
    variable.first = variable.last = entry.time;
  }
  variable.longest_gap = std::max(variable.longest_gap, entry.time - variable.last);
  variable.first = std::min(variable.first, entry.time);
  variable.last = std::max(variable.last, entry.time);
  variable.bytes += line.text.size() + 1;
  if (!variable.sources.contains(entry.source)) {
    variable.sources.emplace(entry.source);
  }
  if (entry.number) {
    variable.numbers.Add(*entry.number);
  }
}

std::vector<VariableStatistics> AlogStatistics::Variables() const {
  std::vector<VariableStatistics> sorted;
  sorted.reserve(variables_.size());
  for (const auto& [name, variable] : variables_) {
    sorted.push_back(variable);
  }
  std::ranges::sort(sorted, {}, &VariableStatistics::name);
  return sorted;
}

}  // namespace limpet
