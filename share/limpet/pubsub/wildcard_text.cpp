// SPDX-License-Identifier: MIT
#include "limpet/pubsub/wildcard_text.hpp"

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

std::string_view Trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

}  // namespace

std::optional<WildcardFilter> ParseWildcard(std::string_view text) {
  WildcardFilter filter;
  bool has_pattern = false;
  while (!text.empty()) {
    const auto comma = std::min(text.find(','), text.size());
    const std::string_view field = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    const auto equals = field.find('=');
    if (equals == std::string_view::npos) {
      return std::nullopt;
    }
    const std::string_view name = Trimmed(field.substr(0, equals));
    const std::string_view value = Trimmed(field.substr(equals + 1));
    if (name == "AppPattern") {
      filter.app_pattern = value;
      has_pattern = true;
    } else if (name == "VarPattern") {
      filter.variable_pattern = value;
      has_pattern = true;
    } else if (name == "Interval") {
      const std::optional<double> interval = ParseNumber(value);
      if (!interval) {
        return std::nullopt;
      }
      filter.interval = Seconds(*interval);
    }
  }
  return has_pattern ? std::optional(filter) : std::nullopt;
}

std::string TextOf(const WildcardFilter& filter) {
  return fmt::format("AppPattern={},VarPattern={},Interval={}", filter.app_pattern,
                     filter.variable_pattern, TextOf(filter.interval.value()));
}

}  // namespace limpet
