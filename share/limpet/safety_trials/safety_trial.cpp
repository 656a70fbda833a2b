// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/safety_trial.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

constexpr Seconds kFaultAfter(3.0);   ///< the phase began
constexpr Seconds kLeastLimit(10.0);  ///< that mission_time may have
constexpr double kUp_m = 0.5;         ///< a vehicle that is shallower has come up

/// What SURVEY_PHASE says in a phase.
std::string WordOf(SafetyPhase phase) {
  std::string word(NameOf(phase));
  std::ranges::transform(word, word.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

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
      fault_ = time + (tested_.fault.empty() ? Seconds(0.0) : kFaultAfter);
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
std::filesystem::path FaultyScenario(const TrialPlaces& places, const SafetyCase& tested,
                                     SafetyPhase phase) {
  const std::filesystem::path source = places.mission_folder / "scenario.yaml";
  std::ifstream in(source);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::filesystem::path file = places.scratch / "scenario.yaml";
  std::ofstream out(file);
  out << text << "\n";
  if (!tested.fault.empty()) {
    out << fmt::format("faults:\n  - {{{}, when: SURVEY_PHASE = {}, at_s: {:g}}}\n", tested.fault,
                       WordOf(phase), kFaultAfter.value());
  }
  return std::filesystem::absolute(file);
}

/// A behavior that stops the vehicle throughout the phase: one without a point to go to.
void AddFailingBehavior(MissionFile& mission, const TrialPlaces& places, SafetyPhase phase) {
  const auto helm = std::ranges::find_if(mission.blocks, [](const ConfigBlock& block) {
    return EqualsIgnoringCase(block.name, "pHelm");
  });
  if (helm == mission.blocks.end()) {
    throw ConfigError(
        {{.file = mission.file, .line = 0}, "pHelm", "the mission has no such block"});
  }
  const std::filesystem::path file = std::filesystem::absolute(places.scratch / "failing.bhv");
  std::ofstream(file) << fmt::format(
      "Behavior = BHV_AbortToPoint\n{{\n  name = failing\n  speed = 0.1\n"
      "  condition = SURVEY_PHASE = {}\n}}\n",
      WordOf(phase));
  helm->entries.push_back(
      {.key = "behaviors", .value = file.string(), .where = {.file = file.string(), .line = 1}});
}

SessionPlan PlanOf(const TrialPlaces& places, std::uint64_t seed) {
  SessionPlan plan;
  plan.session = "discovery";
  plan.mission_folder = places.mission_folder;
  plan.run_folder = places.scratch / "run";
  plan.seed = seed;
  return plan;
}

/// Time under way when the phase begins, of the mission without a fault; found by flying it.
Seconds BeginOf(SafetyPhase phase, const MissionFile& mission, const TrialPlaces& places,
                std::uint64_t seed) {
  std::optional<Seconds> under_way, begin;
  static_cast<void>(RunSession(mission, PlanOf(places, seed), [&](const Message& message) {
    if (message.name != topics::kSurveyPhase.name) return;
    const SafetyPhase now = SafetyPhaseOf(std::get<std::string>(message.value));
    if (now != SafetyPhase::kIdle && !under_way) under_way = message.time;
    if (now == phase && !begin) begin = message.time;
  }));
  return begin ? *begin - *under_way : Seconds(0.0);
}

/// Words of `settings`, one after the other.
void ApplySettings(MissionFile& mission, std::string settings,
                   const std::function<Seconds()>& begin) {
  constexpr std::string_view kBegin = "BEGIN_S";
  if (const std::size_t at = settings.find(kBegin); at != std::string::npos) {
    const Seconds limit = std::max(begin() + Seconds(1.0), kLeastLimit);
    settings.replace(at, kBegin.size(), fmt::format("{:.1f}", limit.value()));
  }
  std::istringstream words(settings);
  for (std::string setting; words >> setting;) {
    ApplySetting(mission, setting);
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
  const std::string scenario = FaultyScenario(places, tested, phase).string();
  MissionFile faulty = mission;
  if (!tested.fault.starts_with("what: disk")) {  // else a log would only cost time
    std::erase_if(faulty.launches,
                  [](const LaunchEntry& launch) { return launch.binary == "pLog"; });
  }
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    ApplySetting(faulty, fmt::format("{}.scenario={}", app, scenario));
  }
  const auto begin = [&, calm = faulty] { return BeginOf(phase, calm, places, seed); };
  ApplySettings(faulty, std::string(tested.settings), begin);
  if (tested.is_behavior) AddFailingBehavior(faulty, places, phase);
  TrialWatch watch(tested, phase);
  const SessionOutcome outcome = RunSession(
      faulty, PlanOf(places, seed), [&watch](const Message& message) { watch.Hear(message); });
  return watch.Result(outcome);
}

}  // namespace limpet
