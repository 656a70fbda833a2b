// SPDX-License-Identifier: MIT
#include "limpet/core/same_value.hpp"

#include <cmath>
#include <optional>

#include "limpet/core/number_text.hpp"

namespace limpet {

bool IsSameValue(std::string_view a, std::string_view b) {
  constexpr double kSlack = 1e-9;
  const std::optional<double> first = ParseNumber(a);
  const std::optional<double> other = ParseNumber(b);
  if (!first || !other) return a == b;
  return std::abs(*first - *other) <= kSlack * std::abs(*first);
}

}  // namespace limpet
