// SPDX-License-Identifier: MIT
#include "apps/pSafety/safety_app.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "apps/pSafety/safety_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/byte_units.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr Seconds kActionPeriod(1.0), kStatePeriod(5.0), kDiskPeriod(10.0);
constexpr Seconds kRecallTime(2.0);  ///< a database without a former state sends none
/// What is only counted or compared need not come at its full rate.
constexpr Seconds kImuPeriod(0.25), kPressurePeriod(0.25);

}  // namespace

SafetyApp::SafetyApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      settings_(params.Applied(context.name)),
      signs_(context.runs_live ? std::max(1.0, context.warp) : 1.0),
      ladder_(settings_),
      started_(now()) {
  SubscribeToNavigation();
  SubscribeToProcesses();
  SubscribeToVehicle();
  ExpectSensors();
  Subscribe(topics::kSafetyReset, &SafetyApp::OnReset);
  if (context.is_restarted) Subscribe(topics::kSafetyState, &SafetyApp::OnFormerState);
}

void SafetyApp::SubscribeToNavigation() {
  Subscribe(topics::kNavState, &SafetyApp::Hear<NavState>);
  SubscribeIfWritten(topics::kDvlData, &SafetyApp::Hear<DvlSample>);
  SubscribeIfWritten(topics::kGpsData, &SafetyApp::Hear<GpsFix>);
  SubscribeIfWritten(topics::kImuData, &SafetyApp::Hear<ImuSample>, kImuPeriod);
  SubscribeIfWritten(topics::kDepthSensor, &SafetyApp::OnDepth, kPressurePeriod);
  SubscribeIfWritten(topics::kObstacleSonar, &SafetyApp::Hear<SonarPing>);
  SubscribeIfWritten(topics::kDetections, &SafetyApp::OnDetections);
}

void SafetyApp::SubscribeToProcesses() {
  SubscribeIfWritten(topics::kSurveyPhase, &SafetyApp::OnPhase);
  SubscribeIfWritten(topics::kSurveyArea, &SafetyApp::OnArea);
  SubscribeIfWritten(topics::kSurveyHome, &SafetyApp::OnHome);
  SubscribeIfWritten(topics::kDesiredSpeed, &SafetyApp::OnSpeed);
  SubscribeIfWritten(topics::kDesiredDepth, &SafetyApp::OnWantedDepth);
  SubscribeIfWritten(topics::kDesiredHeading, &SafetyApp::OnCourse);
  SubscribeIfWritten(topics::kThrusterCommand, &SafetyApp::Hear<ThrusterCommand>);
  SubscribeIfWritten(topics::kHelmState, &SafetyApp::OnHelmState);
  SubscribeIfWritten(topics::kHelmAllStop, &SafetyApp::OnAllStop);
  SubscribeIfWritten(topics::kBehaviorError, &SafetyApp::OnBehaviorError);
  SubscribeIfWritten(topics::kLaunchStatus, &SafetyApp::OnProcesses);
  SubscribeIfWritten(topics::kLaunchMemory, &SafetyApp::OnMemory);
  SubscribeIfWritten(topics::kLaunchProcessor, &SafetyApp::OnProcessor);
  SubscribeIfWritten(topics::kPlanTime, &SafetyApp::OnPlanTime);
}

void SafetyApp::SubscribeToVehicle() {
  SubscribeIfWritten(topics::kLeak, &SafetyApp::OnLeak);
  SubscribeIfWritten(topics::kBattery, &SafetyApp::OnBattery);
  SubscribeIfWritten(topics::kEnergyState, &SafetyApp::OnEnergy);
  SubscribeIfWritten(topics::kShoreBeat, &SafetyApp::OnShoreBeat);
  SubscribeIfWritten(topics::kLogState, &SafetyApp::OnLog);
  SubscribeIfWritten(topics::kWallClock, &SafetyApp::OnWallClock);
}

void SafetyApp::ExpectSensors() {
  const std::string named = context().Global(kVehicleFileGlobal);
  if (named.empty()) return;  // a mission that says of no vehicle what it is
  if (LoadMissionVehicle(named, context().mission_folder).sensors.sonar.is_present) {
    signs_.ExpectSonar();
  }
}

void SafetyApp::OnReset(const Stamped<bool>& reset) {
  if (!reset.value) return;
  ReportEvent(events::kSafetyReset, "what the rules asked for is lifted: " + ActionText());
  ladder_.Reset(now());
}

void SafetyApp::OnFormerState(const Stamped<SafetyState>& state) {
  if (has_recalled_ || state.time >= started_) return;
  has_recalled_ = true;
  for (const SafetyRuleState& former : state.value.rules) {
    const auto rule = std::ranges::find(SafetyRules(), former.rule, &SafetyRule::name);
    const std::optional<SafetyAction> action = SafetyActionNamed(former.stands);
    if (rule != SafetyRules().end() && action) ladder_.Recall(rule->id, *action, now());
  }
}

void SafetyApp::LookAtDisk(Seconds now) {
  if (disk_seen_ && now - *disk_seen_ < kDiskPeriod) return;
  disk_seen_ = now;
  const std::optional<std::uint64_t> room = context().disk->Room(context().run_folder);
  if (room) signs_.HearRoom(static_cast<double>(*room) / kBytesPerMib);
}

void SafetyApp::Tick(Seconds now) {
  // What it said in a former life stands; saying `none` before it is heard would lift that.
  if (context().is_restarted && !has_recalled_ && now - started_ < kRecallTime) return;
  LookAtDisk(now);
  const SafetyMeasures measures = signs_.At(now);
  ladder_.Update(measures, signs_.phase(), now);
  TellWarnings();
  if (ladder_.action() != told_ || !action_told_) TellChange(told_);
  if (!action_told_ || now - *action_told_ >= kActionPeriod) {
    action_told_ = now;
    Publish(topics::kSafetyAction, std::string(NameOf(ladder_.action())));
  }
  if (!state_told_ || now - *state_told_ >= kStatePeriod) {
    state_told_ = now;
    Publish(topics::kSafetyState, State());
  }
}

void SafetyApp::TellChange(SafetyAction former) {
  told_ = ladder_.action();
  action_told_.reset();
  if (told_ == former) return;
  ReportEvent(events::kSafetyAction, ActionText());
  if (told_ == SafetyAction::kReturn) Publish(topics::kReturn, true);
}

void SafetyApp::TellWarnings() {
  std::string standing;
  for (const SafetyRule& rule : SafetyRules()) {
    const SafetyAction stands = ladder_.StandingOf(rule.id);
    if (stands == SafetyAction::kNone) {
      ClearWarning(warnings::kTripped, rule.name);
      continue;
    }
    standing += fmt::format("{}={} ", rule.name, NameOf(stands));
    Warn(warnings::kTripped.Of(rule.name), fmt::format("{}: {}", NameOf(stands), rule.meaning));
  }
  if (standing != standing_) {
    standing_ = std::move(standing);
    state_told_.reset();
  }
}

SafetyState SafetyApp::State() const {
  SafetyState state{.action = std::string(NameOf(ladder_.action())),
                    .rule = {},
                    .since = ladder_.since().value(),
                    .rules = {}};
  if (ladder_.leading() != nullptr) state.rule = ladder_.leading()->name;
  for (const SafetyRule& rule : SafetyRules()) {
    const SafetyAction stands = ladder_.StandingOf(rule.id);
    state.rules.push_back(
        {.rule = std::string(rule.name),
         .margin = ladder_.MarginOf(rule.id),
         .stands = std::string(stands == SafetyAction::kNone ? "" : NameOf(stands))});
  }
  return state;
}

std::string SafetyApp::ActionText() const {
  return ladder_.leading() == nullptr
             ? "none"
             : fmt::format("{}: {}", ladder_.leading()->name, NameOf(ladder_.action()));
}

void SafetyApp::Report(ReportLines& report) const {
  report.Pair("Action", ActionText());
  report.Pair("Phase", std::string(NameOf(signs_.phase())));
  ReportTable table({"rule", ">limit", ">margin", "stands"});
  for (const SafetyRule& rule : SafetyRules()) {
    const auto index = static_cast<std::size_t>(rule.id);
    const std::optional<double> margin = ladder_.MarginOf(rule.id);
    const SafetyAction stands = ladder_.StandingOf(rule.id);
    table.AddRow({std::string(rule.name),
                  rule.limit.key.empty()
                      ? ""
                      : fmt::format("{:g} {}", settings_.limits[index], rule.limit.unit),
                  settings_.is_off[index] ? "off"
                  : margin                ? fmt::format("{:.2f}", *margin)
                                          : "-",
                  stands == SafetyAction::kNone ? "" : std::string(NameOf(stands))});
  }
  report.Add(table);
}

LIMPET_REGISTER_APP(SafetyApp, "pSafety", 5.0);

}  // namespace limpet
