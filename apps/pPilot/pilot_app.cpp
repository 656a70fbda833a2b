// SPDX-License-Identifier: MIT
#include "apps/pPilot/pilot_app.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/pPilot/pilot_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

Pilot::Gains GainsOf(const PilotApp::Params& params) {
  Pilot::Gains gains;
  gains.heading.heading = params.heading_gain;
  gains.heading.rate = params.heading_rate_gain;
  gains.heading.max_rate = params.max_turn_rate.value();
  gains.speed.speed = params.speed_gain;
  gains.depth.depth = params.depth_gain;
  gains.depth.rate = params.depth_rate_gain;
  gains.depth.max_rate = params.max_dive_speed.value();
  gains.depth.afloat_depth = params.afloat_depth.value();
  gains.sway.max_force = params.max_sway.value();
  return gains;
}

}  // namespace

PilotApp::PilotApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      pilot_(
          GainsOf(params),
          LoadMissionVehicle(context.Global(kVehicleFileGlobal), context.mission_folder).params) {
  Subscribe(topics::kNavState, &PilotApp::OnNav);
  Subscribe(topics::kDesiredHeading, &PilotApp::OnHeading);
  Subscribe(topics::kDesiredSpeed, &PilotApp::OnSpeed);
  Subscribe(topics::kDesiredDepth, &PilotApp::OnDepth);
  Subscribe(topics::kDesiredTurnRate, &PilotApp::OnTurnRate);
  Subscribe(topics::kManualOverride, &PilotApp::OnOverride);
  Subscribe(topics::kHelmAllStop, &PilotApp::OnAllStop);
  SubscribeIfWritten(topics::kSafetyAction, &PilotApp::OnSafety);
}

void PilotApp::OnSafety(const Stamped<std::string>& action) {
  const std::optional<SafetyAction> named = SafetyActionNamed(action.value);
  if (!named) {
    Refuse(topics::kSafetyAction.name, fmt::format("`{}` is no action", action.value));
    return;
  }
  ClearWarning(warnings::kRefusedInput, topics::kSafetyAction.name);
  safety_ = *named;
  if (safety_ != SafetyAction::kHold) held_.reset();
}

void PilotApp::OnNav(const Stamped<NavState>& nav) {
  if (!IsPlausible(nav.value)) {
    Refuse(topics::kNavState.name, "fields that are not finite or not of this world");
    return;
  }
  ClearWarning(warnings::kRefusedInput, topics::kNavState.name);
  // What pNav itself does not vouch for is not flown by.
  nav_ = nav.value.is_usable() ? Latest<NavState>({now(), nav.value}) : std::nullopt;
}

void PilotApp::HearWish(const std::string& name, double value, const PlausibleRange& range,
                        Latest<double>& wish) {
  if (!range.Has(value)) {
    Refuse(name, fmt::format("`{}` is not within {:g} to {:g}", value, range.low, range.high));
    return;
  }
  ClearWarning(warnings::kRefusedInput, name);
  wish = {now(), value};
}

void PilotApp::OnHeading(const Stamped<double>& degrees) {
  HearWish(topics::kDesiredHeading.name, degrees.value, kPlausibleHeading, heading_);
}
void PilotApp::OnSpeed(const Stamped<double>& speed) {
  HearWish(topics::kDesiredSpeed.name, speed.value, kPlausibleSpeed, speed_);
}
void PilotApp::OnDepth(const Stamped<double>& depth) {
  HearWish(topics::kDesiredDepth.name, depth.value, kPlausibleDepth, depth_);
}
void PilotApp::OnTurnRate(const Stamped<double>& rate) {
  HearWish(topics::kDesiredTurnRate.name, rate.value, kPlausibleTurnRate, turn_rate_);
}

void PilotApp::Refuse(const std::string& name, const std::string& what) {
  ++refused_[name];
  Warn(warnings::kRefusedInput.Of(name), what + ": treated as not heard");
}

void PilotApp::KeepUp(Seconds now) {
  if (nav_) {
    nav_->time = std::min(nav_->time, now);
  }
  for (Latest<double>* wish : {&heading_, &speed_, &depth_, &turn_rate_}) {
    if (*wish) {
      (*wish)->time = std::min((*wish)->time, now);
    }
  }
}

PilotApp::Mode PilotApp::Judge(Seconds now) const {
  if (is_manual_) {
    return Mode::kManual;
  }
  if (safety_ >= SafetyAction::kSurface) {
    return Mode::kSurfacing;
  }
  if (safety_ == SafetyAction::kHold && nav_) {
    return IsFresh(nav_, now) ? Mode::kHolding : Mode::kNoNavigation;
  }
  if (!heading_ || !speed_ || !depth_) {
    return Mode::kWaiting;
  }
  if (!IsFresh(heading_, now) || !IsFresh(speed_, now) || !IsFresh(depth_, now)) {
    return is_halted_ ? Mode::kHalted : Mode::kNoWishes;
  }
  return IsFresh(nav_, now) ? Mode::kFlying : Mode::kNoNavigation;
}

void PilotApp::WarnOf(Mode mode) {
  if (mode == Mode::kNoWishes) {
    Warn(warnings::kDesiredStale, "no fresh DESIRED_*: thrusters stopped, the vehicle floats up");
  } else {
    ClearWarning(warnings::kDesiredStale);
  }
  if (mode == Mode::kNoNavigation) {
    Warn(warnings::kNavStale, "no fresh NAV_STATE: thrusters stopped, the vehicle floats up");
  } else {
    ClearWarning(warnings::kNavStale);
  }
}

DesiredMotion PilotApp::Desired(Seconds now) const {
  const bool is_degraded = safety_ == SafetyAction::kDegrade;
  return {.yaw = YawFromMoosHeading(heading_->value),
          .speed =
              is_degraded ? std::min(speed_->value, params_.degraded_speed.value()) : speed_->value,
          .depth = depth_->value,
          .turn_rate = IsFresh(turn_rate_, now) ? turn_rate_->value : 0.0};
}

ThrusterCommand PilotApp::Control(Seconds now, double dt) {
  const NavState& nav = nav_->value;
  if (mode_ == Mode::kSurfacing) return pilot_.Rise(nav, dt);
  if (mode_ != Mode::kHolding) return pilot_.Update(nav, Desired(now), dt);
  if (!held_) held_ = {.yaw = nav.yaw, .depth = nav.down};
  return pilot_.Update(
      nav, {.yaw = held_->yaw, .speed = 0.0, .depth = held_->depth, .turn_rate = 0.0}, dt);
}

bool PilotApp::IsControlled(Seconds now) const {
  return mode_ == Mode::kFlying || mode_ == Mode::kHolding ||
         (mode_ == Mode::kSurfacing && IsFresh(nav_, now));
}

void PilotApp::Fly(Seconds now) {
  if (!last_step_) {
    pilot_.Reset(nav_->value);
    last_step_ = now;
  }
  const Seconds dt = now - *last_step_;
  last_step_ = now;
  command_ = Control(now, dt.value());
  const auto shares = command_.Shares();
  if (!std::ranges::all_of(shares, [](double share) { return std::isfinite(share); })) {
    Warn(warnings::kCommandNotFinite,
         "the control laws gave no number: thrusters stopped, laws reset");
    Rest();
    return;
  }
  ClearWarning(warnings::kCommandNotFinite);
  Publish(topics::kThrusterCommand, command_);
}

void PilotApp::Rest() {
  last_step_.reset();
  command_ = ThrusterCommand{};
  Publish(topics::kThrusterCommand, command_);
}

void PilotApp::Tick(Seconds now) {
  KeepUp(now);
  const Mode former = mode_;
  mode_ = Judge(now);
  WarnOf(mode_);
  if (IsControlled(now)) {
    Fly(now);
  } else if (mode_ != Mode::kManual || (former != Mode::kManual && last_step_)) {
    Rest();  // under manual override once: somebody else may write the variable
  }
}

/// The last word must not be thrust.
void PilotApp::Finish(Seconds) {
  if (mode_ != Mode::kManual) {
    Rest();
  }
}

LIMPET_REGISTER_APP(PilotApp, "pPilot", 10.0);

}  // namespace limpet
