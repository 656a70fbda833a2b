// SPDX-License-Identifier: MIT
#include "limpet/log_tools/entry_filter.hpp"

#include <algorithm>

#include "limpet/pubsub/database.hpp"
#include "limpet/pubsub/wildcard_list.hpp"

namespace limpet {
std::vector<CommandOption> EntryFilter::Options() {
  const ValueRule seconds = AnyNumber("seconds since the start of the log");
  return {
      {.names = "--source",
       .value = "PATTERN",
       .meaning = "only entries written by such an app",
       .is_repeatable = true},
      {.names = "--value", .value = "TEXT", .meaning = "only entries whose value contains TEXT"},
      {.names = "--from",
       .value = "S",
       .meaning = "only entries from then on, in seconds since the start of the log",
       .rule = seconds},
      {.names = "--to", .value = "S", .meaning = "only entries up to then", .rule = seconds}};
}

EntryFilter EntryFilter::Of(const Arguments& given, std::vector<std::string> names) {
  EntryFilter filter(std::move(names));
  filter.sources_ = given.All("source");
  filter.from_ = given.Number("from");
  filter.to_ = given.Number("to");
  filter.part_of_value_ = given.Find("value");
  if (filter.from_ && filter.to_ && *filter.from_ > *filter.to_) {
    throw UsageError("--from lies behind --to");
  }
  return filter;
}

bool EntryFilter::AcceptsName(std::string_view name) {
  if (names_.empty()) {
    return true;
  }
  key_ = name;
  const auto [verdict, is_new] = verdicts_.try_emplace(key_, false);
  if (is_new) {
    verdict->second = IsChosen(names_, name);
  }
  return verdict->second;
}

bool EntryFilter::Accepts(const AlogEntry& entry) {
  return (!from_ || entry.time >= *from_) && (!to_ || entry.time <= *to_) &&
         AcceptsName(entry.name) && IsChosen(sources_, entry.source) &&
         (!part_of_value_ || entry.value.find(*part_of_value_) != std::string_view::npos);
}

}  // namespace limpet
