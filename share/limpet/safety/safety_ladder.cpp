// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_ladder.hpp"

#include <cmath>

namespace limpet {

SafetySettings::SafetySettings() {
  for (std::size_t i = 0; i < kSafetyRules; ++i) {
    limits[i] = SafetyRules()[i].limit.value;
    holds[i] = SafetyRules()[i].hold;
  }
}

void SafetyLadder::Raise(Row& row, SafetyAction action, Seconds now) {
  row.inside_since.reset();
  if (action > row.stands) {
    row.stands = action;
    row.stands_since = now;
  }
}

void SafetyLadder::Lift(Row& row) {
  row.stands = SafetyAction::kNone;
  row.stands_since.reset();
}

void SafetyLadder::UpdateRow(std::size_t index, std::optional<double> measure, SafetyPhase phase,
                             Seconds now) {
  const SafetyRule& rule = SafetyRules()[index];
  Row& row = rows_[index];
  if (row.stands == SafetyAction::kHold && rule.ActionIn(phase) < SafetyAction::kHold) {
    Lift(row);  // who is held on the way home never gets there
  }
  const bool is_known = measure && std::isfinite(*measure) && !settings_.is_off[index];
  row.margin =
      is_known ? std::optional(rule.Margin({.value = *measure, .limit = settings_.limits[index]}))
               : std::nullopt;
  if (!is_known) {
    row.inside_since.reset();  // what is not known is not over
    return;
  }
  const SafetyAction asked = rule.ActionIn(phase);
  if (*row.margin < 0.0 && asked != SafetyAction::kNone) {
    row.beyond_since = row.beyond_since.value_or(now);
    if (now - *row.beyond_since >= settings_.holds[index]) Raise(row, asked, now);
  } else {
    row.beyond_since.reset();
  }
  const bool is_over = *row.margin >= rule.hysteresis;
  if (!is_over || !rule.clears_after || row.stands > SafetyAction::kHold) {
    row.inside_since.reset();
    return;
  }
  row.inside_since = row.inside_since.value_or(now);
  if (now - *row.inside_since >= *rule.clears_after) {
    Lift(row);
  }
}

void SafetyLadder::Update(const SafetyMeasures& measures, SafetyPhase phase, Seconds now) {
  for (std::size_t i = 0; i < kSafetyRules; ++i) {
    UpdateRow(i, measures[i], phase, now);
  }
  Settle(now);
}

void SafetyLadder::Settle(Seconds now) {
  const Row* first = nullptr;
  const SafetyRule* rule = nullptr;
  for (std::size_t i = 0; i < kSafetyRules; ++i) {
    const Row& row = rows_[i];
    if (row.stands == SafetyAction::kNone) continue;
    const bool leads = first == nullptr || row.stands > first->stands ||
                       (row.stands == first->stands && *row.stands_since < *first->stands_since);
    if (leads) {
      first = &row;
      rule = &SafetyRules()[i];
    }
  }
  const SafetyAction highest = first != nullptr ? first->stands : SafetyAction::kNone;
  if (highest != action_) since_ = now;
  action_ = highest;
  leading_ = rule;
}

void SafetyLadder::Reset(Seconds now) {
  for (Row& row : rows_) {
    row = {};
  }
  Settle(now);
}

void SafetyLadder::Recall(SafetyRuleId id, SafetyAction action, Seconds now) {
  Raise(rows_[static_cast<std::size_t>(id)], action, now);
  Settle(now);
}

SafetyAction SafetyLadder::StandingOf(SafetyRuleId id) const {
  return rows_[static_cast<std::size_t>(id)].stands;
}

std::optional<double> SafetyLadder::MarginOf(SafetyRuleId id) const {
  return rows_[static_cast<std::size_t>(id)].margin;
}

}  // namespace limpet
