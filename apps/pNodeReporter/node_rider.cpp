// SPDX-License-Identifier: MIT
#include "apps/pNodeReporter/node_rider.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

Expected<NodeRider> NodeRider::Parse(std::string_view text) {
  NodeRider rider;
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view words(part);
    const std::string_view value =
        equals == std::string::npos ? std::string_view() : Trim(words.substr(equals + 1));
    if (const auto error = rider.Set(Trim(words.substr(0, equals)), value)) {
      return *error;
    }
  }
  if (rider.variable_.empty()) {
    return Error{
        fmt::format("`{}` names no variable; e.g. var=DB_UPTIME, policy=always, rfld=upt", text)};
  }
  if (rider.field_.empty()) {
    rider.field_ = rider.variable_;
  }
  return rider;
}

std::optional<Error> NodeRider::Set(std::string_view key, std::string_view value) {
  if (EqualsIgnoringCase(key, "var")) {
    variable_ = std::string(value);
  } else if (EqualsIgnoringCase(key, "rfld")) {
    field_ = std::string(value);
  } else if (EqualsIgnoringCase(key, "prec")) {
    const auto number = ParseNumber(value);
    if (!number || *number < 0.0 || *number > 10.0) {
      return Error{fmt::format("prec `{}` is not allowed; allowed: 0 to 10", value)};
    }
    decimals_ = static_cast<int>(*number);
  } else if (EqualsIgnoringCase(key, "policy")) {
    is_always_ = EqualsIgnoringCase(value, "always");
    rides_when_updated_ = EqualsIgnoringCase(value.substr(0, 7), "updated");
    std::string_view period = rides_when_updated_ ? Trim(value.substr(7)) : value;
    period.remove_prefix(period.starts_with('+') ? 1 : 0);
    const auto seconds = ParseNumber(period);
    const bool needs_period = !is_always_ && !(rides_when_updated_ && period.empty());
    if (needs_period && !(seconds && *seconds > 0.0)) {
      return Error{fmt::format(
          "policy `{}` is not allowed; allowed: always, updated, updated+seconds, seconds", value)};
    }
    period_ = needs_period ? std::optional(Seconds(*seconds)) : std::nullopt;
  } else {
    return Error{fmt::format("`{}` is unknown; known: var, policy, rfld, prec", key)};
  }
  return std::nullopt;
}

void NodeRider::Hear(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    value_ = DecimalText(*number, decimals_);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    // Braces keep what stands between commas in one field.
    value_ = text->find(',') == std::string::npos ? *text : "{" + *text + "}";
    std::ranges::replace_if(
        value_, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '_');
  }
  has_news_ = true;
}

std::optional<std::string> NodeRider::Take(Seconds now) {
  const bool is_due = period_ && (!last_ || now - *last_ >= *period_);
  const bool rides = is_always_ || (rides_when_updated_ && has_news_) || is_due;
  if (value_.empty() || !rides) {
    return std::nullopt;
  }
  has_news_ = false;
  last_ = now;
  return field_ + "=" + value_;
}

namespace {

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter == '"' || letter == '\\' ? "\\" : "";
    quoted += letter;
  }
  return quoted + '"';
}

/// Parts between commas that stand in no braces.
std::vector<std::string> SplitOutsideBraces(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char letter : text) {
    depth += letter == '{' ? 1 : 0;
    depth -= letter == '}' ? 1 : 0;
    if (letter == ',' && depth <= 0) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

}  // namespace

std::string JsonOfReport(std::string_view report) {
  std::string json;
  for (const std::string& part : SplitOutsideBraces(report)) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string value = part.substr(std::min(equals + 1, part.size()));
    json += fmt::format("{}{}:{}", json.empty() ? "" : ",", Quoted(part.substr(0, equals)),
                        Quoted(value));
  }
  return "{" + json + "}";
}

}  // namespace limpet
