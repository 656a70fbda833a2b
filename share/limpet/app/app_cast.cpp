// SPDX-License-Identifier: MIT
#include "limpet/app/app_cast.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kField = "!@#";
constexpr std::string_view kItem = "!@";
constexpr double kLongestRequest = 30.0;  ///< [s]
constexpr std::size_t kLongestKey = 200;

/// The text on one line and without separators. A trailing `!` would join with what follows, a
/// leading `#` with what goes before.
std::string Blunt(std::string_view text) {
  std::string blunt(text.starts_with('#') ? " " : "");
  for (const char c : text) {
    if (c == '@' && blunt.ends_with('!')) {
      blunt += ' ';
    }
    blunt += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
  }
  if (blunt.ends_with('!')) {
    blunt += ' ';
  }
  return blunt;
}

std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    joined += (i == 0 ? std::string_view() : kItem);
    joined += Blunt(texts[i]);
  }
  return joined;
}

std::vector<std::string_view> SplitBy(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + separator.size());
  }
  parts.push_back(text);
  return parts;
}

std::vector<std::string> Texts(std::string_view value) {
  const std::vector<std::string_view> parts = SplitBy(value, kItem);
  return {parts.begin(), parts.end()};
}

int CountOf(std::string_view text) {
  const std::int64_t count = ParseInteger(text).value_or(0);
  return static_cast<int>(std::clamp<std::int64_t>(count, 0, std::numeric_limits<int>::max()));
}

CountedWarning WarningOf(std::string_view item) {
  const std::size_t colon = item.find(':');
  return {.text = std::string(item.substr(std::min(colon + 1, item.size()))),
          .count = CountOf(item.substr(0, colon))};
}

void ReadField(std::string_view name, std::string_view value, AppCast& cast) {
  if (name == "proc") {
    cast.process = value;
  } else if (name == "iter") {
    cast.iteration = ParseInteger(value).value_or(0);
  } else if (name == "node") {
    cast.node = value;
  } else if (name == "messages") {
    cast.messages = Texts(value);
    cast.messages.pop_back();  // each line ends with a separator
  } else if (name == "config_warnings") {
    cast.config_warnings = Texts(value);
  } else if (name == "events") {
    cast.events = Texts(value);
  } else if (name == "run_warning_total") {
    cast.run_warning_total = CountOf(value);
  } else if (name == "run_warnings") {
    cast.run_warnings.clear();
    for (const std::string_view item : SplitBy(value, kItem)) {
      cast.run_warnings.push_back(WarningOf(item));
    }
  }
}

}  // namespace

std::string EncodeAppCast(const AppCast& cast) {
  std::string text =
      fmt::format("proc={}{}iter={}{}", Blunt(cast.process), kField, cast.iteration, kField);
  if (!cast.node.empty()) {
    text += fmt::format("node={}{}", Blunt(cast.node), kField);
  }
  text += fmt::format("iter={}{}messages=", cast.iteration, kField);
  for (const std::string& line : cast.messages) {
    text += fmt::format("{}{}", Blunt(line), kItem);
  }
  text += kField;
  if (!cast.config_warnings.empty()) {
    text += "config_warnings=" + Joined(cast.config_warnings);
  }
  text += fmt::format("{}events_total={}{}", kField, cast.events.size(), kField);
  if (!cast.events.empty()) {
    text += "events=" + Joined(cast.events);
  }
  text += fmt::format("{}run_warning_total={}{}", kField, cast.run_warning_total, kField);
  if (!cast.run_warnings.empty()) {
    std::vector<std::string> warnings;
    for (const CountedWarning& warning : cast.run_warnings) {
      warnings.push_back(fmt::format("{}:{}", warning.count, warning.text));
    }
    text += "run_warnings=" + Joined(warnings);
  }
  return text;
}

std::optional<AppCast> DecodeAppCast(std::string_view text) {
  AppCast cast;
  for (const std::string_view field : SplitBy(text, kField)) {
    if (const std::size_t equals = field.find('='); equals != std::string_view::npos) {
      ReadField(field.substr(0, equals), field.substr(equals + 1), cast);
    }
  }
  return cast.process.empty() ? std::nullopt : std::optional<AppCast>(std::move(cast));
}

bool AppCastRequest::IsFor(std::string_view app_name, std::string_view community) const {
  return (app == "all" || app == app_name) && (node == "all" || node == community);
}

std::optional<AppCastRequest> ParseAppCastRequest(std::string_view text) {
  AppCastRequest request{.node = "all", .app = "all", .duration = Seconds(0.0), .key = ""};
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view name = Trim(std::string_view(part).substr(0, equals));
    const std::string_view value =
        Trim(std::string_view(part).substr(std::min(equals + 1, part.size())));
    if (EqualsIgnoringCase(name, "node")) {
      request.node = value;
    } else if (EqualsIgnoringCase(name, "app")) {
      request.app = value;
    } else if (EqualsIgnoringCase(name, "duration")) {
      request.duration =
          Seconds(std::clamp(ParseNumber(value).value_or(0.0), 0.0, kLongestRequest));
    } else if (EqualsIgnoringCase(name, "key")) {
      request.key = value;
    } else if (EqualsIgnoringCase(name, "thresh")) {
      request.wants_warnings_only = value == "run_warning";
    }
  }
  const bool is_good = !request.key.empty() && request.key.size() <= kLongestKey;
  return is_good ? std::optional<AppCastRequest>(std::move(request)) : std::nullopt;
}

}  // namespace limpet
