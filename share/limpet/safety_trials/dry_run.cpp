// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/dry_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFirst = "discovery";
constexpr const char* kSecond = "change";
constexpr double kAtHome_m = 5.0;     ///< the last fix shows it nearer or farther by that
constexpr double kAtSurface_m = 0.5;  ///< a vehicle that is shallower has come up

/// Keeps the account of a flight.
class DryWatch {
 public:
  void Hear(const Message& message) {
    begun_ = begun_.value_or(message.time);
    if (message.name == topics::kSimTruth.name) {
      HearTruth(*TopicCodec<SimTruth>::Decode(message.value));
    } else if (message.name == topics::kSurveyPhase.name) {
      phase_ = std::get<std::string>(message.value);
    } else if (message.name == topics::kSafetyState.name) {
      HearState(*TopicCodec<SafetyState>::Decode(message.value), message.time);
    } else if (message.name == topics::kSimBattery.name) {
      HearBattery(*TopicCodec<SimBattery>::Decode(message.value));
    } else if (message.name == topics::kEnergyState.name && flight_.energy) {
      flight_.energy->reserve_wh = TopicCodec<EnergyState>::Decode(message.value)->reserve_wh;
    }
  }
  [[nodiscard]] DryFlight Flight(const SessionOutcome& outcome) {
    flight_.ended = outcome.ended;
    flight_.duration_s = outcome.duration.value();
    flight_.down_m = truth_.down;
    flight_.home_error_m =
        start_ ? std::hypot(truth_.north - start_->north, truth_.east - start_->east) : 0.0;
    return flight_;
  }

 private:
  void HearTruth(const SimTruth& truth) {
    if (start_) {
      flight_.way_m += std::hypot(truth.north - truth_.north, truth.east - truth_.east);
    } else {
      start_ = truth;
    }
    truth_ = truth;
  }
  void HearBattery(const SimBattery& battery) {
    if (!flight_.energy) flight_.energy.emplace();
    flight_.energy->used_wh = battery.used_wh;
    flight_.energy->left_wh = battery.charge * battery.capacity_wh;
    flight_.energy->is_off = battery.is_off;
  }
  void HearState(const SafetyState& state, Seconds time) {
    for (const SafetyRuleState& rule : state.rules) {
      const bool is_known = std::ranges::any_of(flight_.tripped, [&rule](const TrippedRule& known) {
        return known.rule == rule.rule && known.action == rule.stands;
      });
      if (rule.stands.empty() || is_known) continue;
      flight_.tripped.push_back({.rule = rule.rule,
                                 .action = rule.stands,
                                 .phase = phase_,
                                 .after_s = (time - *begun_).value(),
                                 .north_m = truth_.north,
                                 .east_m = truth_.east,
                                 .down_m = std::max(0.0, truth_.down)});
    }
  }

  DryFlight flight_;
  std::optional<Seconds> begun_;
  std::optional<SimTruth> start_;
  SimTruth truth_;
  std::string phase_ = "IDLE";
};

std::string TextOf(const TrippedRule& tripped) {
  return fmt::format(
      "rule {} asks for {} after {:.0f} s in {}, north {:.1f}, east {:.1f} m, {:.1f} m deep",
      tripped.rule, tripped.action, tripped.after_s, tripped.phase, tripped.north_m, tripped.east_m,
      tripped.down_m);
}

}  // namespace

std::vector<std::string> DryFlight::Objections() const {
  std::vector<std::string> objections;
  for (const TrippedRule& rule : tripped) {
    if (!rule.IsWarning()) objections.push_back(TextOf(rule));
  }
  if (energy && energy->is_off) {
    objections.push_back(fmt::format("the battery is empty after {:.0f} Wh", energy->used_wh));
  } else if (energy && energy->left_wh < energy->reserve_wh) {
    objections.push_back(
        fmt::format("{:.0f} Wh left at the end, of which {:.0f} Wh were to be in reserve",
                    energy->left_wh, energy->reserve_wh));
  }
  if (ended != "home") {
    objections.push_back(fmt::format("it ended `{}` after {:.0f} s", ended, duration_s));
  }
  if (home_error_m > kAtHome_m || down_m > kAtSurface_m) {
    objections.push_back(
        fmt::format("it did not come home: {:.0f} m from the start, {:.1f} m deep at the end",
                    home_error_m, std::max(0.0, down_m)));
  }
  return objections;
}

std::vector<std::string> DryFlight::Remarks() const {
  std::vector<std::string> remarks;
  for (const TrippedRule& rule : tripped) {
    if (rule.IsWarning()) remarks.push_back(TextOf(rule));
  }
  return remarks;
}

bool TrippedRule::IsWarning() const { return action == NameOf(SafetyAction::kWarn); }

MissionFile PreparedForDryRun(MissionFile mission) {
  std::erase_if(mission.launches,
                [](const LaunchEntry& launch) { return launch.binary == "pLog"; });
  for (const char* setting : {"uSimCamera.camera=boxes", "uSimVehicle.integrator=rk4"}) {
    ApplySetting(mission, setting);
  }
  return mission;
}

std::vector<std::string> DrySessions(const MissionFile& mission, const TrialPlaces& places) {
  const std::vector<std::string> apps = EmbeddedApps(mission);
  const fs::path scenario = ScenarioFileOf(mission, places.mission_folder);
  std::vector<std::string> sessions{kFirst};
  if (std::ranges::find(apps, "pSession") == apps.end() || !fs::exists(scenario)) return sessions;
  const std::vector<std::string> said = SessionsOf(LoadScenario(scenario));
  if (std::ranges::find(said, kSecond) != said.end()) sessions.emplace_back(kSecond);
  return sessions;
}

DryFlight FlyDry(const MissionFile& mission, const TrialPlaces& places, std::uint64_t seed,
                 const std::string& session) {
  const fs::path run = places.scratch / fmt::format("seed-{}", seed);
  SessionPlan plan;
  plan.session = session;
  plan.mission_folder = places.mission_folder;
  plan.run_folder = run / session;
  if (session != kFirst) plan.prior_folder = run / kFirst;
  plan.seed = seed;
  plan.delivers_truth_on_board = false;
  DryWatch watch;
  const SessionOutcome outcome =
      RunSession(mission, plan, [&watch](const Message& message) { watch.Hear(message); });
  DryFlight flight = watch.Flight(outcome);
  flight.session = session;
  return flight;
}

}  // namespace limpet
