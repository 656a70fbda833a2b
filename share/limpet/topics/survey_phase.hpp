// SPDX-License-Identifier: MIT
// The phases that the mission manager walks through, and their names in SURVEY_PHASE.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace limpet {

enum class SurveyPhase { kIdle, kAlign, kDive, kSurvey, kReturn, kAscend, kFix, kDone };

/// Names in the order of the enumeration, as SURVEY_PHASE, logs and missions' conditions have them.
inline constexpr std::array<std::string_view, 8> kSurveyPhaseNames{
    "IDLE", "ALIGN", "DIVE", "SURVEY", "RETURN", "ASCEND", "FIX", "DONE"};

[[nodiscard]] constexpr std::string_view NameOf(SurveyPhase phase) {
  return kSurveyPhaseNames.at(static_cast<std::size_t>(phase));
}

/// Phase that a value of SURVEY_PHASE names; nothing for any other word.
[[nodiscard]] constexpr std::optional<SurveyPhase> SurveyPhaseOf(std::string_view name) {
  const auto found = std::ranges::find(kSurveyPhaseNames, name);
  if (found == kSurveyPhaseNames.end()) return std::nullopt;
  return static_cast<SurveyPhase>(found - kSurveyPhaseNames.begin());
}

/// True where the vehicle covers ground. `name` is a value of SURVEY_PHASE: without a mission
/// manager (a replayed log, a bench) there is none, and all time is survey.
[[nodiscard]] constexpr bool IsSurveying(std::string_view name) {
  return name.empty() || name == NameOf(SurveyPhase::kSurvey);
}

/// True where camera frames are of the ground: from the dive to the way home.
[[nodiscard]] constexpr bool IsMappingPhase(std::string_view name) {
  return IsSurveying(name) || name == NameOf(SurveyPhase::kDive) ||
         name == NameOf(SurveyPhase::kReturn);
}

}  // namespace limpet
