// SPDX-License-Identifier: MIT
#include "limpet/log_tools/entry_filter.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/pubsub/database.hpp"

namespace limpet {
namespace {

bool MatchesAny(const std::vector<std::string>& patterns, std::string_view text) {
  return patterns.empty() || std::ranges::any_of(patterns, [text](const std::string& pattern) {
           return MatchesWildcard(pattern, text);
         });
}

std::optional<double> SecondsOf(const Arguments& given, const std::string& option) {
  const std::optional<std::string> text = given.Find(option);
  if (!text) {
    return std::nullopt;
  }
  const std::optional<double> value = ParseNumber(*text);
  if (!value) {
    throw UsageError(
        fmt::format("--{} takes seconds since the start of the log, not `{}`", option, *text));
  }
  return value;
}

}  // namespace

const std::vector<std::string>& EntryFilter::Options() {
  static const std::vector<std::string> options{"source", "from", "to", "value"};
  return options;
}

EntryFilter EntryFilter::Of(const Arguments& given, std::vector<std::string> names) {
  EntryFilter filter;
  filter.names_ = std::move(names);
  filter.sources_ = given.All("source");
  filter.from_ = SecondsOf(given, "from");
  filter.to_ = SecondsOf(given, "to");
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
    verdict->second = MatchesAny(names_, name);
  }
  return verdict->second;
}

bool EntryFilter::Accepts(const AlogEntry& entry) {
  return (!from_ || entry.time >= *from_) && (!to_ || entry.time <= *to_) &&
         AcceptsName(entry.name) && MatchesAny(sources_, entry.source) &&
         (!part_of_value_ || entry.value.find(*part_of_value_) != std::string_view::npos);
}

}  // namespace limpet
