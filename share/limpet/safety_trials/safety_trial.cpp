// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/safety_trial.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/safety_trials/trial_limit.hpp"
#include "limpet/safety_trials/trial_prop.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

constexpr double kUp_m = 0.5;  ///< a vehicle that is shallower has come up

/// Keeps the account of a flight.
class TrialWatch {
 public:
  TrialWatch(const SafetyCase& tested, SafetyPhase phase) : tested_(tested), begins_in_(phase) {}

  void Hear(const Message& message) {
    if (message.name == topics::kSurveyPhase.name) {
      HearPhase(SafetyPhaseOf(std::get<std::string>(message.value)), message.time);
    } else if (message.name == topics::kSafetyState.name && !answer_) {
      HearState(*TopicCodec<SafetyState>::Decode(message.value), message.time);
    } else if (message.name == topics::kSimTruth.name) {
      down_ = TopicCodec<SimTruth>::Decode(message.value)->down;
    }
    if (fault_ && !answer_) CountMissing(message.time);
  }
  [[nodiscard]] SafetyTrialResult Result(const SessionOutcome& outcome) const;

 private:
  void HearPhase(SafetyPhase phase, Seconds time) {
    phase_ = phase;
    if (phase == begins_in_ && !fault_)
      fault_ = time + (tested_.fault.empty() ? Seconds(0.0) : tested_.after);
    asked_since_.reset();
  }
  void HearState(const SafetyState& state, Seconds time) {
    const std::string_view name = SafetyRuleOf(tested_.rule).name;
    const auto rule = std::ranges::find(state.rules, name, &SafetyRuleState::rule);
    if (rule == state.rules.end() || rule->stands.empty()) {
      HearOthers(state, time);
      return;
    }
    answer_ = {time, SafetyActionNamed(rule->stands).value_or(SafetyAction::kNone)};
    is_false_alarm_ = !fault_ || time < *fault_;
    answered_in_ = phase_;
  }
  /// Another rule may do as much before the one that is tried; the vehicle is as safe.
  void HearOthers(const SafetyState& state, Seconds time) {
    const SafetyAction asked = SafetyRuleOf(tested_.rule).ActionIn(phase_);
    const SafetyAction done = SafetyActionNamed(state.action).value_or(SafetyAction::kNone);
    if (fault_ && instead_.empty() && asked != SafetyAction::kNone && done >= asked) {
      instead_ =
          fmt::format("{}: {} after {:.1f} s", state.rule, state.action, (time - *fault_).value());
    }
  }
  /// For how long the fault has been so in a phase that asks for something, without an answer.
  void CountMissing(Seconds now) {
    const bool asks = SafetyRuleOf(tested_.rule).ActionIn(phase_) != SafetyAction::kNone;
    if (now < *fault_ || !asks || !instead_.empty()) return;
    asked_since_ = asked_since_.value_or(now);
    longest_unanswered_ = std::max(longest_unanswered_, (now - *asked_since_).value());
  }

  const SafetyCase& tested_;
  SafetyPhase begins_in_, phase_ = SafetyPhase::kIdle, answered_in_ = SafetyPhase::kIdle;
  std::optional<Seconds> fault_, asked_since_;
  std::optional<Stamped<SafetyAction>> answer_;
  std::string instead_;
  bool is_false_alarm_ = false;
  double longest_unanswered_ = 0.0;
  double down_ = 0.0;
};

SafetyTrialResult TrialWatch::Result(const SessionOutcome& outcome) const {
  SafetyTrialResult result;
  result.ended = outcome.ended;
  if (is_false_alarm_) {
    result.complaint = fmt::format("{} before the fault began", NameOf(answer_->value));
    return result;
  }
  if (!fault_) {
    result.complaint = fmt::format("{} was never reached", NameOf(begins_in_));
    return result;
  }
  const SafetyRule& rule = SafetyRuleOf(tested_.rule);
  result.instead = answer_ ? "" : instead_;
  if (answer_) {
    result.action = answer_->value;
    result.after_s = (answer_->time - *fault_).value();
    const SafetyAction wanted = rule.ActionIn(answered_in_);
    if (result.action != wanted) {
      result.complaint =
          fmt::format("{} where the table says {}", NameOf(result.action), NameOf(wanted));
    }
  }
  if (longest_unanswered_ > tested_.answer.value()) {
    result.complaint = fmt::format("no answer within {:g} s", tested_.answer.value());
  } else if (outcome.cut) {
    result.complaint = "no end: " + *outcome.cut;
  } else if (down_ > kUp_m) {
    result.complaint = fmt::format("ended {:.1f} m deep", down_);
  }
  return result;
}

/// The scenario with the fault, as a file of the scratch folder.
std::filesystem::path FaultyScenario(const std::filesystem::path& source, const TrialPlaces& places,
                                     const SafetyCase& tested, SafetyPhase phase) {
  std::ifstream in(source);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::filesystem::path file = places.scratch / "scenario.yaml";
  std::ofstream out(file);
  out << text << "\n" << PropLines(LoadScenario(source), tested);
  if (!tested.fault.empty()) {
    out << fmt::format("faults:\n  - {{{}, when: SURVEY_PHASE = {}, at_s: {:g}}}\n", tested.fault,
                       WordOf(phase), tested.after.value());
  }
  return std::filesystem::absolute(file);
}

/// Limit and rules as the trial has them.
void TightenRules(MissionFile& faulty, const SafetyCase& tested, std::optional<double> limit) {
  if (limit) {
    ApplySetting(faulty,
                 fmt::format("pSafety.{}={:.3f}", SafetyRuleOf(tested.rule).limit.key, *limit));
  }
  if (!tested.off.empty()) {
    AddLine(faulty, "pSafety", {.key = "off", .value = std::string(tested.off), .where = {}});
  }
}

}  // namespace

MissionFile ShortenedForTrials(MissionFile mission) {
  std::erase_if(mission.launches,
                [](const LaunchEntry& launch) { return launch.binary == "pSession"; });
  for (const char* setting :
       {"pSurvey.align_s=40", "pSurvey.last_fix_s=40", "pSurvey.fix_wait_min_s=40",
        "pSurvey.max_time_s=130", "pSurvey.lost_s=60", "pSurvey.give_up_s=240",
        "uSimCamera.camera=boxes", "uSimVehicle.integrator=rk4"}) {
    ApplySetting(mission, setting);
  }
  return mission;
}

SafetyTrialResult FlySafetyTrial(const MissionFile& mission, const TrialPlaces& places,
                                 const SafetyCase& tested, SafetyPhase phase, std::uint64_t seed) {
  std::filesystem::create_directories(places.scratch);
  const std::string scenario =
      FaultyScenario(ScenarioFileOf(mission, places.mission_folder), places, tested, phase)
          .string();
  MissionFile faulty = mission;
  if (!tested.fault.starts_with("what: disk")) {  // else a log would only cost time
    std::erase_if(faulty.launches,
                  [](const LaunchEntry& launch) { return launch.binary == "pLog"; });
  }
  AddProp(faulty, places, tested, phase);
  TightenRules(faulty, tested, LimitFor(tested, phase, faulty, places, seed));
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    ApplySetting(faulty, fmt::format("{}.scenario={}", app, scenario));
  }
  TrialWatch watch(tested, phase);
  const SessionOutcome outcome = RunSession(
      faulty, TrialPlan(places, seed), [&watch](const Message& message) { watch.Hear(message); });
  return watch.Result(outcome);
}

}  // namespace limpet
