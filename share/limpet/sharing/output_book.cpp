// SPDX-License-Identifier: MIT
#include "limpet/sharing/output_book.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/pubsub/wildcard.hpp"

namespace limpet {
namespace {

/// The name over there of a variable that a pattern matched.
std::string NameOverThere(const ShareOutput& pattern, const std::string& variable) {
  if (pattern.dest != "^") {
    return pattern.dest + variable;
  }
  const std::size_t literal = pattern.source.size() - 1;  // all but the one `*`
  return pattern.source.front() == '*' ? variable.substr(0, variable.size() - literal)
                                       : variable.substr(literal);
}

}  // namespace

bool OutputBook::Route::IsOver(Seconds now) const {
  if (output.max_shares && shares >= *output.max_shares) {
    return true;
  }
  if (!output.duration) {
    return false;
  }
  return output.duration->value() == 0.0 ? shares > 0 : now - made > *output.duration;
}

bool OutputBook::Route::IsDue(Seconds now) const {
  // A clock that went back must not silence a route.
  return !IsOver(now) && (output.max_hz <= 0.0 || !last || now < *last ||
                          (now - *last).value() * output.max_hz >= 1.0);
}

OutputBook::Route* OutputBook::Find(std::vector<Route>& routes, const ShareOutput& output) {
  const auto found = std::ranges::find_if(routes, [&output](const Route& route) {
    return route.output.source == output.source && route.output.app_pattern == output.app_pattern &&
           route.output.dest == output.dest && route.output.address == output.address;
  });
  return found == routes.end() ? nullptr : &*found;
}

OutputBook::Added OutputBook::Add(const ShareOutput& output, Seconds now) {
  if (!output.is_pattern()) {
    return AddFixed(output, false, now);
  }
  if (Route* known = Find(patterns_, output)) {
    known->output = output;
    known->made = now;
    return Added::kRenewed;
  }
  if (++count_ > kMostRoutes) {
    --count_;
    return Added::kRefused;
  }
  patterns_.push_back({.output = output, .made = now, .last = std::nullopt});
  return Added::kNew;
}

OutputBook::Added OutputBook::AddFixed(const ShareOutput& output, bool is_from_pattern,
                                       Seconds now) {
  std::vector<Route>& routes = fixed_[output.source];
  if (Route* known = Find(routes, output)) {
    known->output = output;
    known->made = now;
    known->shares = 0;
    return Added::kRenewed;
  }
  if (++count_ > kMostRoutes) {
    --count_;
    return Added::kRefused;
  }
  routes.push_back(
      {.output = output, .made = now, .is_from_pattern = is_from_pattern, .last = std::nullopt});
  return Added::kNew;
}

void OutputBook::MeetPatterns(const Message& message, Seconds now) {
  for (const Route& pattern : patterns_) {
    if (!MatchesWildcard(pattern.output.source, message.name)) {
      continue;
    }
    ShareOutput output = pattern.output;
    output.source = message.name;
    output.app_pattern = "*";
    output.dest = NameOverThere(pattern.output, message.name);
    std::vector<Route>& routes = fixed_[message.name];
    if (!output.dest.empty() && Find(routes, output) == nullptr &&
        MatchesWildcard(pattern.output.app_pattern, message.source)) {
      AddFixed(output, true, now);
    }
  }
}

std::vector<OutputBook::Due> OutputBook::TakeDue(const Message& message, Seconds now) {
  if (!patterns_.empty()) {
    MeetPatterns(message, now);
  }
  std::vector<Due> due;
  const auto found = fixed_.find(message.name);
  if (found == fixed_.end()) {
    return due;
  }
  for (Route& route : found->second) {
    if (route.IsDue(now)) {
      ++route.shares;
      route.last = now;
      due.push_back(
          {route.output.dest, route.output.address, route.output.security, route.output.to});
    }
  }
  return due;
}

bool OutputBook::IsNamed(std::string_view variable) const {
  const auto found = fixed_.find(variable);
  return found != fixed_.end() && std::ranges::any_of(found->second, [](const Route& route) {
           return !route.is_from_pattern;
         });
}

bool OutputBook::IsMatched(std::string_view variable) const {
  return std::ranges::any_of(patterns_, [variable](const Route& pattern) {
    return MatchesWildcard(pattern.output.source, variable);
  });
}

std::string OutputBook::Summary(Seconds now) const {
  std::string summary;
  for (const auto& [variable, routes] : fixed_) {
    std::string ends;
    for (const Route& route : routes) {
      if (!route.IsOver(now)) {
        ends += fmt::format("{}{}:{}", ends.empty() ? "" : " & ", route.output.dest,
                            route.output.address.Text());
      }
    }
    if (!ends.empty()) {
      summary += fmt::format("{}{}->{}", summary.empty() ? "" : ", ", variable, ends);
    }
  }
  return summary;
}

}  // namespace limpet
