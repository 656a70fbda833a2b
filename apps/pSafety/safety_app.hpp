// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/app/app.hpp"
#include "limpet/safety/safety_ladder.hpp"
#include "limpet/safety/safety_params.hpp"
#include "limpet/safety/safety_signs.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {

/// Watches what endangers the vehicle and says what is to be done: SAFETY_ACTION, which pPilot,
/// pHelm and pSurvey obey each by itself, and SAFETY_STATE. It has no map and no solver; the rules
/// are a table (limpet/safety/safety_rules.cpp).
class SafetyApp final : public App {
 public:
  using Params = SafetyParams;

  SafetyApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void SubscribeToNavigation();
  void SubscribeToProcesses();
  void SubscribeToVehicle();
  /// What the vehicle's file says it has.
  void ExpectSensors();
  void OnReset(const Stamped<bool>& reset);
  /// What a former life of this process had said.
  void OnFormerState(const Stamped<SafetyState>& state);
  template <class T>
  void Hear(const Stamped<T>& mail) {
    signs_.Hear(mail.value, now());
  }
  void OnProcessor(const Stamped<ProcessorLoad>& load) { signs_.HearProcessor(load.value.percent); }
  void OnArea(const Stamped<SurveyArea>& area) { signs_.Hear(area.value); }
  void OnHome(const Stamped<HomePoint>& home) { signs_.Hear(home.value); }
  void OnDepth(const Stamped<double>& depth) { signs_.HearDepth(depth.value, now()); }
  void OnSpeed(const Stamped<double>& speed) { signs_.HearWantedSpeed(speed.value, now()); }
  void OnWantedDepth(const Stamped<double>& depth) { signs_.HearWantedDepth(depth.value, now()); }
  void OnCourse(const Stamped<double>& degrees) { signs_.HearWantedCourse(degrees.value); }
  void OnDetections(const Stamped<Detections>& frame) { signs_.HearDetections(frame.value, now()); }
  void OnPhase(const Stamped<std::string>& phase) { signs_.HearPhase(phase.value, now()); }
  void OnHelmState(const Stamped<std::string>& state) { signs_.HearHelmState(state.value, now()); }
  void OnAllStop(const Stamped<std::string>& why) { signs_.HearAllStop(why.value, now()); }
  void OnBehaviorError(const Stamped<std::string>&) { signs_.HearBehaviorError(now()); }
  void OnProcesses(const Stamped<std::string>& status) {
    signs_.HearProcesses(status.value, now());
  }
  void OnWallClock(const Stamped<WallClock>& clock) {
    signs_.HearClockSteps(clock.value.steps, now());
  }
  void OnPlanTime(const Stamped<double>& seconds) { signs_.HearPlanTime(seconds.value); }
  void OnMemory(const Stamped<double>& mib) { signs_.HearMemory(mib.value); }
  void OnLog(const Stamped<LogState>& log) { signs_.HearLog(log.value.is_written, now()); }
  void OnLeak(const Stamped<bool>& leak) { signs_.HearLeak(leak.value); }
  void OnBattery(const Stamped<BatteryState>& battery) { signs_.HearCharge(battery.value.charge); }
  void OnEnergy(const Stamped<EnergyState>& energy) { signs_.Hear(energy.value); }
  void OnShoreBeat(const Stamped<double>&) { signs_.HearShore(now()); }

  /// Room on the disk of the run folder; embedded only what the scenario makes of it.
  void LookAtDisk(Seconds now);
  void TellChange(SafetyAction former);
  void TellWarnings();
  [[nodiscard]] SafetyState State() const;
  /// `leak: abort`, or `none`.
  [[nodiscard]] std::string ActionText() const;

  SafetyParams params_;
  SafetySettings settings_;
  SafetySigns signs_;
  SafetyLadder ladder_;
  SafetyAction told_ = SafetyAction::kNone;
  std::string standing_;  ///< rules and what they ask for, as last told
  std::optional<Seconds> action_told_, state_told_, disk_seen_;
  Seconds started_;
  bool has_recalled_ = false;
};

}  // namespace limpet
