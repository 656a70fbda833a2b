// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "limpet/safety/safety_rule.hpp"

namespace limpet {

/// What a mission says of the rules; the table's own unless it says otherwise.
struct SafetySettings {
  SafetySettings();
  std::array<double, kSafetyRules> limits{};
  std::array<Seconds, kSafetyRules> holds{};
  std::array<bool, kSafetyRules> is_off{};
};

/// What each rule watches, in its unit; absent while it is not known.
using SafetyMeasures = std::array<std::optional<double>, kSafetyRules>;

/// Which action is in force. A rule trips when what it watches has been beyond its limit for its
/// hold time; the highest action of all that stand is done. What stands goes only as the table
/// says (a hold also in a phase whose column asks for less), and return, surface and abort only by
/// Reset. Pure, and allocates nothing.
class SafetyLadder {
 public:
  explicit SafetyLadder(const SafetySettings& settings) : settings_(settings) {}

  /// `now` does not go back. A measure that is absent or not finite neither trips nor clears.
  void Update(const SafetyMeasures& measures, SafetyPhase phase, Seconds now);
  /// Lifts everything; what is beyond its limit still trips anew after its hold time.
  void Reset(Seconds now);
  /// Takes up what stood in a former life of the process.
  void Recall(SafetyRuleId id, SafetyAction action, Seconds now);

  [[nodiscard]] SafetyAction action() const { return action_; }
  /// The first rule that asked for the action; null if none does.
  [[nodiscard]] const SafetyRule* leading() const { return leading_; }
  /// When the action came into force; 0 before the first.
  [[nodiscard]] Seconds since() const { return since_; }
  [[nodiscard]] SafetyAction StandingOf(SafetyRuleId id) const;
  /// Margin of the last measure, from the limit inwards; absent if that was.
  [[nodiscard]] std::optional<double> MarginOf(SafetyRuleId id) const;

 private:
  struct Row {
    std::optional<double> margin;
    std::optional<Seconds> beyond_since, inside_since, stands_since;
    SafetyAction stands = SafetyAction::kNone;
  };
  void UpdateRow(std::size_t index, std::optional<double> measure, SafetyPhase phase, Seconds now);
  static void Raise(Row& row, SafetyAction action, Seconds now);
  static void Lift(Row& row);
  /// Finds the highest of what stands.
  void Settle(Seconds now);

  SafetySettings settings_;
  std::array<Row, kSafetyRules> rows_{};
  SafetyAction action_ = SafetyAction::kNone;
  const SafetyRule* leading_ = nullptr;
  Seconds since_;
};

}  // namespace limpet
