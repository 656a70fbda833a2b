// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/safety_trial.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

constexpr double kFaultAfter_s = 3.0;  ///< the phase began
constexpr double kUp_m = 0.5;          ///< a vehicle that is shallower has come up

constexpr SafetyPhase kFromDive = SafetyPhase::kDive, kToTheEnd = SafetyPhase::kAscend;

// clang-format off
constexpr std::array<SafetyCase, 26> kCases{{
    {"leak", "what: leak", Id::kLeak, Seconds(3.0)},
    {"battery low", "what: battery", Id::kBatteryLow, Seconds(12.0)},
    {"battery critical", "what: battery, size: 0.05", Id::kBatteryCritical, Seconds(12.0)},
    {"energy short", "what: battery, size: 0.14", Id::kEnergyHome, Seconds(8.0)},
    {"cells lost", "what: cells_lost", Id::kGaugeOff, Seconds(50.0)},
    {"DVL silent", "what: dvl_silent", Id::kDvlSilent, Seconds(31.0)},
    {"DVL without lock", "what: dvl_no_lock", Id::kDvlSilent, Seconds(31.0)},
    {"DVL flipped", "what: dvl_flipped", Id::kDvlSilent, Seconds(50.0)},
    {"DVL stuck", "what: dvl_stuck", Id::kDvlStuck, Seconds(6.0)},
    {"altitude stuck", "what: altitude_stuck", Id::kAltitudeStuck, Seconds(6.0)},
    {"altitude off", "what: altitude_biased", Id::kDepthAgainstAltitude, Seconds(6.0), kFromDive},
    {"depth silent", "what: depth_silent", Id::kDepthSilent, Seconds(16.0)},
    {"depth stuck", "what: depth_stuck", Id::kDepthStuck, Seconds(11.0)},
    {"IMU stuck", "what: imu_stuck", Id::kImuStuck, Seconds(4.0)},
    {"IMU silent", "what: imu_silent", Id::kNavigationSilent, Seconds(27.0)},
    {"GPS jump", "what: gps_jump", Id::kGpsJump, Seconds(15.0)},
    {"thrusters dead", "what: thrusters_weak, size: 0", Id::kNoProgress, Seconds(60.0)},
    {"camera silent", "what: camera_silent", Id::kDetectorSilent, Seconds(21.0), kFromDive},
    {"helm hangs", "what: app_hangs, app: pHelm", Id::kHelmSilent, Seconds(16.0)},
    {"pilot hangs", "what: app_hangs, app: pPilot", Id::kPilotSilent, Seconds(16.0)},
    {"navigation hangs", "what: app_hangs, app: pNav", Id::kNavigationSilent, Seconds(21.0)},
    {"disk full", "what: disk_full", Id::kDiskFull, Seconds(11.0)},
    {"disk failing", "what: disk_failing", Id::kLogFailed, Seconds(33.0)},
    {"false boxes", "what: false_boxes", Id::kDetectorStorm, Seconds(8.0), kFromDive},
    {"link lost", "what: link_lost", Id::kLinkLost, Seconds(21.0), SafetyPhase::kAlign, kToTheEnd, "pSafety.link_lost_s=20"},
    {"clock stepped", "what: clock_stepped", Id::kClockStepped, Seconds(1.0)},
}};
// clang-format on

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
    if (phase == begins_in_ && !fault_) fault_ = time + Seconds(kFaultAfter_s);
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
  double longest_unanswered_ = 0.0;
  double down_ = 0.0;
};

SafetyTrialResult TrialWatch::Result(const SessionOutcome& outcome) const {
  SafetyTrialResult result;
  result.ended = outcome.ended;
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
  std::ofstream(file) << text
                      << fmt::format("\nfaults:\n  - {{{}, when: SURVEY_PHASE = {}, at_s: {:g}}}\n",
                                     tested.fault, WordOf(phase), kFaultAfter_s);
  return std::filesystem::absolute(file);
}

/// Words of `settings`, one after the other.
void ApplySettings(MissionFile& mission, std::string_view settings) {
  std::istringstream words{std::string(settings)};
  for (std::string setting; words >> setting;) {
    ApplySetting(mission, setting);
  }
}

}  // namespace

std::span<const SafetyCase> SafetyCases() { return kCases; }

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
  ApplySettings(faulty, tested.settings);
  SessionPlan plan;
  plan.session = "discovery";
  plan.mission_folder = places.mission_folder;
  plan.run_folder = places.scratch / "run";
  plan.seed = seed;
  TrialWatch watch(tested, phase);
  const SessionOutcome outcome =
      RunSession(faulty, plan, [&watch](const Message& message) { watch.Hear(message); });
  return watch.Result(outcome);
}

}  // namespace limpet
