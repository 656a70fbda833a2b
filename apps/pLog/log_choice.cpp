// SPDX-License-Identifier: MIT
#include "apps/pLog/log_choice.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/pubsub/database.hpp"

namespace limpet {
namespace {

bool MatchesAny(const std::vector<std::string>& lines, std::string_view name) {
  return std::ranges::any_of(lines, [name](const std::string& line) {
    return std::ranges::any_of(Split(line, ','), [name](const std::string& pattern) {
      return MatchesWildcard(Trim(pattern), name);
    });
  });
}

}  // namespace

Expected<LogRequest> ParseLogRequest(std::string_view line) {
  const Error failure{fmt::format("`{}` is not VARIABLE @ seconds [,NOSYNC] [,MONITOR]", line)};
  LogRequest request;
  const std::vector<std::string> parts = Split(line, ',');
  const std::string_view first = parts.empty() ? std::string_view() : parts[0];
  const std::size_t at = first.find('@');
  request.name = std::string(Trim(first.substr(0, at)));
  if (at != std::string_view::npos) {
    const std::optional<double> interval = ParseNumber(first.substr(at + 1));
    if (!interval || *interval < 0.0) {
      return failure;
    }
    request.interval = Seconds(*interval);
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    request.is_synced = request.is_synced && !EqualsIgnoringCase(Trim(parts[i]), "NOSYNC");
    request.is_monitored = request.is_monitored || EqualsIgnoringCase(Trim(parts[i]), "MONITOR");
  }
  return request.name.empty() ? Expected<LogRequest>(failure) : request;
}

bool LogChoice::Add(const LogRequest& request) {
  return rates_.try_emplace(request.name, Rate{request.interval, std::nullopt}).second;
}

std::vector<std::string> LogChoice::Requested() const {
  std::vector<std::string> names;
  std::ranges::transform(rates_, std::back_inserter(names),
                         [](const auto& rate) { return rate.first; });
  return names;
}

LogChoice::Verdict LogChoice::FileFor(const Message& message) {
  if (const auto found = rates_.find(message.name); found != rates_.end()) {
    Rate& rate = found->second;
    const bool is_early = rate.last && message.time - *rate.last < rate.interval;
    if (is_early && message.time >= *rate.last) {  // a clock set back must not silence it
      return std::nullopt;
    }
    rate.last = message.time;
    return LogLine::File::kAsync;
  }
  const auto [verdict, is_new] = verdicts_.try_emplace(message.name);
  if (is_new) {
    verdict->second = VerdictOn(message.name);
  }
  return verdict->second;
}

LogChoice::Verdict LogChoice::VerdictOn(std::string_view name) const {
  if (!patterns_.is_used) {
    return std::nullopt;
  }
  if (MatchesAny(patterns_.wanted, name) && !MatchesAny(patterns_.omitted, name)) {
    return LogLine::File::kAsync;
  }
  return patterns_.has_exclusion_log ? Verdict(LogLine::File::kExcluded) : std::nullopt;
}

}  // namespace limpet
