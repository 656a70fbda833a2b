// SPDX-License-Identifier: MIT
// One fault in one phase of a mission, flown: whether its rule answers as the table says.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/mission/mission_file.hpp"
#include "limpet/safety/safety_rule.hpp"

namespace limpet {

/// Where a trial sets the limit of the rule, so that the answer comes within minutes, in a mission
/// of any size.
struct TrialLimit {
  enum class Kind {
    kAsItIs,
    kGiven,       ///< `value`
    kBeyondCalm,  ///< so far beyond what a flight without the fault ever reaches
    kAtBegin      ///< a time under way: when the phase begins in such a flight
  };
  Kind kind = Kind::kAsItIs;
  double value = 0.0;  ///< in the rule's unit
};

/// What a trial adds to the mission, for what no fault alone provokes.
enum class TrialProp {
  kNone,
  kFailingBehavior,  ///< one that stops all while the phase lasts
  kObstacle,         ///< ahead of the start, so that a sonar has an echo there
  kZone              ///< a keep-out zone north of the operating region
};

/// A fault, and which rule is to answer it within which time of its beginning.
struct SafetyCase {
  std::string_view name;  ///< of the row
  /// As a scenario says it, without `when`: `what: dvl_stuck`. Empty: nothing fails, the limit
  /// alone is reached.
  std::string_view fault;
  SafetyRuleId rule = SafetyRuleId::kLeak;
  Seconds answer;
  /// The first and the last phase that it may begin in to be told from what has always been so.
  SafetyPhase from = SafetyPhase::kAlign, to = SafetyPhase::kAscend;
  TrialLimit limit{};
  std::string_view off{};  ///< a rule that would answer before it
  TrialProp prop = TrialProp::kNone;
  Seconds after{3.0};  ///< the phase began, the fault begins

  [[nodiscard]] bool ShowsFrom(SafetyPhase phase) const { return phase >= from && phase <= to; }
};
[[nodiscard]] std::span<const SafetyCase> SafetyCases();

/// Phases that a fault may begin in.
inline constexpr std::array kTriedPhases{SafetyPhase::kAlign, SafetyPhase::kDive,
                                         SafetyPhase::kSurvey, SafetyPhase::kReturn,
                                         SafetyPhase::kAscend};

/// What came of a flight.
struct SafetyTrialResult {
  SafetyAction action = SafetyAction::kNone;  ///< that the rule asked for first
  double after_s = 0.0;                       ///< since the fault began
  /// Another rule that answered before it, in a phase where the table asks for something, by as
  /// strong an action; `no_progress: surface after 33.7 s`. Empty if there was none.
  std::string instead;
  std::string ended;  ///< home, aborted, ...
  /// What is wrong; empty: the rule did what the table says, in time, or another one did
  /// as much, and the vehicle is up.
  std::string complaint;
};

/// A mission that is over in a few minutes, with every phase long enough for most rules.
[[nodiscard]] MissionFile ShortenedForTrials(MissionFile mission);

/// Where a trial is flown: the mission's folder, and one that it may write to and that is its own.
struct TrialPlaces {
  std::filesystem::path mission_folder, scratch;
};

/// `mission` as shortened, with boxes for a camera. Throws ConfigError if it cannot be flown.
[[nodiscard]] SafetyTrialResult FlySafetyTrial(const MissionFile& mission,
                                               const TrialPlaces& places, const SafetyCase& tested,
                                               SafetyPhase phase, std::uint64_t seed);

}  // namespace limpet
