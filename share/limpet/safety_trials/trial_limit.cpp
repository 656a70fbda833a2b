// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/trial_limit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {
namespace {

constexpr double kJustBegun_s = 1.0;  ///< the phase stands for so long when its time is over

/// What a flight without a fault shows of one rule.
class CalmFlight {
 public:
  CalmFlight(const SafetyRule& rule, SafetyPhase phase) : rule_(rule), wanted_(phase) {}

  void Hear(const Message& message) {
    if (message.name == topics::kSurveyPhase.name) {
      phase_ = SafetyPhaseOf(std::get<std::string>(message.value));
      if (phase_ != SafetyPhase::kIdle && !under_way_) under_way_ = message.time;
      if (phase_ == wanted_ && !begin_) begin_ = message.time;
    } else if (message.name == topics::kSafetyState.name &&
               rule_.ActionIn(phase_) != SafetyAction::kNone) {
      HearState(*TopicCodec<SafetyState>::Decode(message.value));
    }
  }
  /// Time under way when the phase begins; absent: it never does.
  [[nodiscard]] std::optional<Seconds> begin() const {
    return begin_ ? std::optional(*begin_ - *under_way_) : std::nullopt;
  }
  /// Least margin that was seen, from the limit inwards; absent: nobody knows.
  [[nodiscard]] std::optional<double> least_margin() const { return least_margin_; }

 private:
  void HearState(const SafetyState& state) {
    const auto found = std::ranges::find(state.rules, rule_.name, &SafetyRuleState::rule);
    if (found == state.rules.end() || !found->margin) return;
    least_margin_ = std::min(least_margin_.value_or(*found->margin), *found->margin);
  }

  const SafetyRule& rule_;
  SafetyPhase wanted_, phase_ = SafetyPhase::kIdle;
  std::optional<Seconds> under_way_, begin_;
  std::optional<double> least_margin_;
};

/// The rule's limit as the mission has it.
double MissionLimit(const MissionFile& mission, const SafetyRule& rule) {
  const ConfigBlock* block = mission.Block("pSafety");
  const ConfigEntry* line = block != nullptr ? block->Find(std::string(rule.limit.key)) : nullptr;
  return line != nullptr ? ParseNumber(line->value).value_or(rule.limit.value) : rule.limit.value;
}

/// So far beyond the worst that the flight has shown.
std::optional<double> Beyond(const CalmFlight& flight, const SafetyRule& rule, double limit,
                             double by) {
  if (!flight.least_margin()) return std::nullopt;
  const bool is_above = rule.side == SafetyRule::Side::kAbove;
  const double worst = is_above ? limit - *flight.least_margin() : limit + *flight.least_margin();
  return is_above ? worst + by : worst - by;
}

}  // namespace

SessionPlan TrialPlan(const TrialPlaces& places, std::uint64_t seed) {
  SessionPlan plan;
  plan.session = "discovery";
  plan.mission_folder = places.mission_folder;
  plan.run_folder = places.scratch / "run";
  plan.seed = seed;
  return plan;
}

std::optional<double> LimitFor(const SafetyCase& tested, SafetyPhase phase, const MissionFile& calm,
                               const TrialPlaces& places, std::uint64_t seed) {
  using Kind = TrialLimit::Kind;
  if (tested.limit.kind == Kind::kAsItIs) return std::nullopt;
  if (tested.limit.kind == Kind::kGiven) return tested.limit.value;
  const SafetyRule& rule = SafetyRuleOf(tested.rule);
  CalmFlight flight(rule, phase);
  static_cast<void>(RunSession(calm, TrialPlan(places, seed),
                               [&flight](const Message& message) { flight.Hear(message); }));
  std::optional<double> limit;
  if (tested.limit.kind == Kind::kBeyondCalm) {
    limit = Beyond(flight, rule, MissionLimit(calm, rule), tested.limit.value);
  } else if (flight.begin()) {
    limit = flight.begin()->value() + kJustBegun_s;
  }
  return limit ? std::optional(std::clamp(*limit, rule.limit.least, rule.limit.most)) : limit;
}

}  // namespace limpet
