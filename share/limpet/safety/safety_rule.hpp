// SPDX-License-Identifier: MIT
// The table of what endangers the vehicle: each rule is declared once, in safety_rules.cpp. The
// parameters of pSafety's block, `limpet safety list` and docs/safety.md come from it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "limpet/core/units.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Parts of a mission that ask for different answers.
enum class SafetyPhase { kIdle, kAlign, kDive, kSurvey, kReturn, kAscend };
inline constexpr std::size_t kSafetyPhases = 6;

/// `idle`, `align`, ...
[[nodiscard]] std::string_view NameOf(SafetyPhase phase);
/// The phase for a value of SURVEY_PHASE: FIX counts as ascent, IDLE, DONE and other words as idle.
[[nodiscard]] SafetyPhase SafetyPhaseOf(std::string_view survey_phase);

/// The rules, in the order of their table.
enum class SafetyRuleId : std::size_t {
  kLeak,
  kBatteryLow,
  kBatteryCritical,
  kGaugeOff,
  kEnergyHome,
  kDepthOverLimit,
  kAltitudeLow,
  kOutsideRegion,
  kInsideZone,
  kFarFromHome,
  kMissionTime,
  kNavigationSilent,
  kSigmaHigh,
  kSigmaOverLimit,
  kDvlSilent,
  kDvlLost,
  kDvlOutliers,
  kDvlStuck,
  kAltitudeStuck,
  kDepthSilent,
  kDepthStuck,
  kImuOutliers,
  kImuStuck,
  kSonarSilent,
  kSonarStuck,
  kDepthAgainstAltitude,
  kGpsJump,
  kNoProgress,
  kNoDepthProgress,
  kThrustersSaturated,
  kHelmSilent,
  kHelmIdle,
  kBehaviorFailed,
  kPilotSilent,
  kAppDown,
  kDetectorSilent,
  kDetectorLost,
  kDetectorStorm,
  kClockStepped,
  kDiskLow,
  kDiskFull,
  kLogFailed,
  kLinkLost,
  kPlannerSlow,
  kMemoryHigh,
  kProcessorHigh
};
inline constexpr std::size_t kSafetyRules = 46;

/// One row. What it watches is a number that must not go beyond a limit.
struct SafetyRule {
  enum class Side { kAbove, kBelow };
  struct Limit {
    std::string_view key;  ///< of the block; empty: nothing to set, it is so or not
    std::string_view unit;
    double value = 0.5;
    double least = 0.0, most = 1.0;  ///< of what a block may say
  };

  SafetyRuleId id = SafetyRuleId::kLeak;
  std::string_view name;
  std::string_view meaning;  ///< what it watches, as the operator reads it
  Side side = Side::kAbove;  ///< of the limit where it trips
  Limit limit;
  Seconds hold;             ///< so long beyond the limit before it trips
  double hysteresis = 0.0;  ///< this far inside the limit it is over
  /// Then, after so long, a rule that asks for no more than to hold lets go by itself. Absent: as
  /// return, surface and abort always do, it asks until SAFETY_RESET.
  std::optional<Seconds> clears_after;
  std::array<SafetyAction, kSafetyPhases> actions{};

  [[nodiscard]] SafetyAction ActionIn(SafetyPhase phase) const {
    return actions[static_cast<std::size_t>(phase)];
  }
  struct Measured {
    double value = 0.0, limit = 0.0;
  };
  /// How far a value is inside the limit: below 0 beyond it.
  [[nodiscard]] double Margin(const Measured& measured) const {
    return side == Side::kAbove ? measured.limit - measured.value : measured.value - measured.limit;
  }
};

[[nodiscard]] std::span<const SafetyRule, kSafetyRules> SafetyRules();
[[nodiscard]] const SafetyRule& SafetyRuleOf(SafetyRuleId id);

}  // namespace limpet
