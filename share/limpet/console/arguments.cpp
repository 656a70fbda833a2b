// SPDX-License-Identifier: MIT
#include "limpet/console/arguments.hpp"

#include <cstdint>

#include "limpet/core/number_text.hpp"
#include "limpet/core/require.hpp"

namespace limpet {

const Arguments::Given& Arguments::Of(const std::string& option) const {
  const auto found = options_.find(option);
  LIMPET_REQUIRE(found != options_.end(), option);
  return found->second;
}

bool Arguments::Has(const std::string& option) const { return !Of(option).values.empty(); }

std::optional<std::string> Arguments::Find(const std::string& option) const {
  const Given& given = Of(option);
  if (!given.values.empty()) return given.values.back();
  return given.fallback.empty() ? std::nullopt : std::optional(given.fallback);
}

std::vector<std::string> Arguments::All(const std::string& option) const {
  return Of(option).values;
}

int Arguments::Integer(const std::string& option) const {
  const std::optional<std::string> text = Find(option);
  const std::optional<std::int64_t> value = text ? ParseInteger(*text) : std::nullopt;
  LIMPET_REQUIRE(value.has_value(), option);
  return static_cast<int>(*value);
}

std::optional<double> Arguments::Number(const std::string& option) const {
  const std::optional<std::string> text = Find(option);
  return text ? ParseNumber(*text) : std::nullopt;
}

}  // namespace limpet
