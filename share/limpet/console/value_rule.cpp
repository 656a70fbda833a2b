// SPDX-License-Identifier: MIT
#include "limpet/console/value_rule.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {

ValueRule WholeNumber(int least, int most) {
  constexpr int kNoLimit = 2'000'000'000;
  return {.allowed = most < kNoLimit ? fmt::format("a whole number from {} to {}", least, most)
                                     : fmt::format("a whole number of at least {}", least),
          .accepts = [least, most](const std::string& text) {
            const std::optional<std::int64_t> value = ParseInteger(text);
            return value && *value >= least && *value <= most;
          }};
}

ValueRule NumberBetween(double least, double most, const std::string& unit) {
  return {.allowed = fmt::format("{:g} to {:g}{}{}", least, most, unit.empty() ? "" : " ", unit),
          .accepts = [least, most](const std::string& text) {
            const std::optional<double> value = ParseNumber(text);
            return value && *value >= least && *value <= most;
          }};
}

ValueRule AnyNumber(const std::string& what) {
  return {.allowed = what,
          .accepts = [](const std::string& text) { return ParseNumber(text).has_value(); }};
}

ValueRule OneOf(std::vector<std::string> words) {
  std::string allowed;
  for (std::size_t i = 0; i < words.size(); ++i) {
    allowed += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return {.allowed = std::move(allowed), .accepts = [words](const std::string& text) {
            return std::ranges::find(words, text) != words.end();
          }};
}

ValueRule NotEmpty(const std::string& what) {
  return {.allowed = what, .accepts = [](const std::string& text) { return !text.empty(); }};
}

}  // namespace limpet
