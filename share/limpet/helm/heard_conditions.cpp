// SPDX-License-Identifier: MIT
#include "limpet/helm/heard_conditions.hpp"

#include <algorithm>

namespace limpet {

bool HoldAll(std::span<Condition> conditions, const VehicleState& state) {
  const auto lookup = [&state](std::string_view name) {
    const Stamped<Value>* heard = state.Heard(name);
    return heard == nullptr ? nullptr : &heard->value;
  };
  return std::ranges::all_of(
      conditions, [&](Condition& condition) { return condition.Holds(lookup, state.now); });
}

}  // namespace limpet
