// SPDX-License-Identifier: MIT
#include "limpet/core/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "limpet/core/config.hpp"

namespace limpet {

std::string TextOf(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

namespace {
template <class T>
std::optional<T> ParseWhole(std::string_view text) {
  text = Trim(text);
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);  // from_chars takes a minus only
  }
  T value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}
}  // namespace

std::optional<double> ParseNumber(std::string_view text) {
  const std::optional<double> value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  return ParseWhole<std::int64_t>(text);
}

std::optional<bool> ParseFlag(std::string_view text) {
  text = Trim(text);
  for (const char* yes : {"true", "yes", "on"}) {
    if (EqualsIgnoringCase(text, yes)) {
      return true;
    }
  }
  for (const char* no : {"false", "no", "off"}) {
    if (EqualsIgnoringCase(text, no)) {
      return false;
    }
  }
  const std::optional<double> number = ParseNumber(text);
  return number ? std::optional<bool>(*number > 0.0) : std::nullopt;
}

}  // namespace limpet
