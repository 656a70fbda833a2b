// SPDX-License-Identifier: MIT
// Random histories of what the rules watch: an action in force is never lowered but by a reset, or,
// of those that may let go, by a rule whose measure is known to be well inside its limit, or of a
// hold by a phase that does not ask for it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

#include "limpet/safety/safety_ladder.hpp"

namespace {

using limpet::SafetyAction;

/// Beyond the limit, on it, just inside, well inside, unknown, not a number.
std::optional<double> MeasureFrom(const limpet::SafetyRule& rule, std::uint8_t byte) {
  const double inwards = rule.side == limpet::SafetyRule::Side::kAbove ? -1.0 : 1.0;
  const std::array<double, 4> insides{-1.0, 0.0, 0.5 * rule.hysteresis, rule.hysteresis + 1.0};
  if (byte % 6 == 4) return std::nullopt;
  if (byte % 6 == 5) return std::numeric_limits<double>::quiet_NaN();
  return rule.limit.value + inwards * insides.at(byte % 6);
}

void Require(bool holds) {
  if (!holds) std::abort();
}

bool MayHaveLetGo(const limpet::SafetyLadder& ladder, limpet::SafetyPhase phase) {
  for (const limpet::SafetyRule& rule : limpet::SafetyRules()) {
    const std::optional<double> margin = ladder.MarginOf(rule.id);
    const bool holds_elsewhere =
        std::ranges::find(rule.actions, SafetyAction::kHold) != rule.actions.end() &&
        rule.ActionIn(phase) < SafetyAction::kHold;
    if (holds_elsewhere) return true;
    if (rule.clears_after && margin && *margin >= rule.hysteresis &&
        ladder.StandingOf(rule.id) == SafetyAction::kNone) {
      return true;
    }
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limpet::SafetyLadder ladder{limpet::SafetySettings()};
  limpet::SafetyMeasures measures{};
  limpet::Seconds now(0.0);
  for (std::size_t i = 0; i + 3 < size; i += 4) {
    const std::size_t index = data[i] % limpet::kSafetyRules;
    measures[index] = MeasureFrom(limpet::SafetyRules()[index], data[i + 1]);
    now += limpet::Seconds(0.25 * data[i + 2]);
    const auto phase = static_cast<limpet::SafetyPhase>(data[i + 3] % limpet::kSafetyPhases);
    if (data[i + 3] > 250) {
      ladder.Reset(now);
      Require(ladder.action() == SafetyAction::kNone && ladder.leading() == nullptr);
      continue;
    }
    const SafetyAction former = ladder.action();
    ladder.Update(measures, phase, now);
    const SafetyAction action = ladder.action();
    Require(former <= SafetyAction::kHold || action >= former);
    Require(action >= former || MayHaveLetGo(ladder, phase));
    Require((action == SafetyAction::kNone) == (ladder.leading() == nullptr));
  }
  return 0;
}
