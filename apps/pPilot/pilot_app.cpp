// SPDX-License-Identifier: MIT
#include "apps/pPilot/pilot_app.hpp"

#include "limpet/app/registry.hpp"
#include "limpet/core/frames.hpp"

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
  gains.depth.surface_depth = params.surface_depth.value();
  gains.sway.max_force = params.max_sway.value();
  return gains;
}

}  // namespace

PilotApp::PilotApp(const AppContext& context, const Params& params)
    : App(context), params_(params), pilot_(GainsOf(params), VehicleParams{}) {
  Subscribe(topics::kNavState, &PilotApp::OnNav);
  Subscribe(topics::kDesiredHeading, &PilotApp::OnHeading);
  Subscribe(topics::kDesiredSpeed, &PilotApp::OnSpeed);
  Subscribe(topics::kDesiredDepth, &PilotApp::OnDepth);
  Subscribe(topics::kDesiredTurnRate, &PilotApp::OnTurnRate);
  Subscribe(topics::kManualOverride, &PilotApp::OnOverride);
}

bool PilotApp::MayMove(Seconds now) {
  const bool has_wishes = heading_ && speed_ && depth_;
  if (is_manual_ || !has_wishes) return false;
  if (!IsFresh(nav_, now)) {
    Warn("NAV_STALE", "no fresh NAV_STATE: thrusters stopped, the vehicle floats up");
    return false;
  }
  ClearWarning("NAV_STALE");
  return true;
}

DesiredMotion PilotApp::Desired(Seconds now) {
  DesiredMotion desired{.yaw = YawFromMoosHeading(heading_->value),
                        .speed = speed_->value,
                        .depth = depth_->value,
                        .turn_rate = IsFresh(turn_rate_, now) ? turn_rate_->value : 0.0};
  if (IsFresh(heading_, now) && IsFresh(speed_, now) && IsFresh(depth_, now)) {
    ClearWarning("DESIRED_STALE");
    return desired;
  }
  Warn("DESIRED_STALE", "no fresh DESIRED_*: surge stopped, heading and depth held");
  desired.speed.reset();
  desired.turn_rate = 0.0;
  return desired;
}

void PilotApp::Fly(Seconds now) {
  if (!last_step_) {
    pilot_.Reset(nav_->value);
    last_step_ = now;
  }
  const Seconds dt = now - *last_step_;
  last_step_ = now;
  command_ = pilot_.Update(nav_->value, Desired(now), dt.value());
  Publish(topics::kThrusterCommand, command_);
}

/// Says so once: under manual override somebody else may write the variable.
void PilotApp::Rest() {
  if (!last_step_) return;
  last_step_.reset();
  command_ = ThrusterCommand{};
  Publish(topics::kThrusterCommand, command_);
}

void PilotApp::Tick(Seconds now) { MayMove(now) ? Fly(now) : Rest(); }

LIMPET_REGISTER_APP(PilotApp, "pPilot", 10.0);

}  // namespace limpet
