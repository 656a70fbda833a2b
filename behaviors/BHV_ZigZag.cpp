// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ZigZag.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

/// The line drawn from the vehicle along a heading.
DrawnText HeadingLine(const std::string& label, const MapLeg& line, const std::string& color,
                      bool is_active) {
  return DrawnTextOf({.label = label,
                      .form = SeglistShape{{line.from, line.to}},
                      .style = {.label_color = "off",
                                .edge_color = color,
                                .vertex_color = color,
                                .vertex_size = 2.0,
                                .edge_size = 1.0},
                      .is_active = is_active},
                     label);
}

bool IsDrawn(const VisualHints& hints, const char* hint) {
  return ParseFlag(hints.Text(hint, "true")).value_or(true);
}

}  // namespace

bool BHV_ZigZag::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  run_ = dynamic_cast<const BHV_ZigZag&>(former).run_;
  if (HasKey(keys, {"stem_hdg"})) run_.stem = params_.stem_heading.value();
  if (HasKey(keys, {"speed"})) run_.speed = run_.begin_speed = params_.speed.value();
  if (HasKey(keys, {"mod_speed"})) {
    run_.speed =
        params_.speed_change ? std::max(0.0, run_.speed + *params_.speed_change) : run_.begin_speed;
  }
  return true;
}

void BHV_ZigZag::Start(const VehicleState& state) {
  const double speed = params_.takes_speed ? state.speed() : params_.speed.value();
  run_ = {.stem = params_.takes_heading ? state.nav.yaw : params_.stem_heading.value(),
          .speed = speed,
          .begin_speed = speed,
          .legs_ever = run_.legs_ever,
          .from = state.place(),
          .last = state.place(),
          .leg_begin_speed = state.speed(),
          .least_speed = {}};
}

void BHV_ZigZag::Travel(const VehicleState& state) {
  const double step = DistanceBetween(run_.last, state.place());
  run_.last = state.place();
  run_.odo += step;
  run_.leg_odo += step;
  run_.pair_odo += step;
  run_.least_speed = std::min(run_.least_speed.value_or(state.speed()), state.speed());
}

MapLeg BHV_ZigZag::Stem() const {
  return {run_.from, Project(run_.from, {.bearing = run_.stem, .distance = 1.0})};
}

bool BHV_ZigZag::IsDone() const {
  // The first, from the stem, is half a leg: MOOS-IvP flies one more than it counts.
  const bool is_flown = params_.legs > 0 && run_.legs > params_.legs;
  const bool is_far =
      params_.longest_stem && std::abs(Stem().Along(run_.last)) >= params_.longest_stem->value();
  return is_flown || is_far;
}

double BHV_ZigZag::Target() const {
  const double angle = params_.angle.value();
  return WrapAngle(run_.stem + (run_.side == Side::kPort        ? -angle
                                : run_.side == Side::kStarboard ? angle
                                                                : 0.0));
}

double BHV_ZigZag::Steered(double heading) const {
  if (!params_.is_fierce) return Target();
  const double off = params_.fierce_angle.value_or(params_.angle).value();
  return WrapAngle(heading + (run_.side == Side::kPort ? -off : off));
}

/// Near its heading, or beyond it on the side that it turns to.
bool BHV_ZigZag::HasTurned(double heading) const {
  const double left = WrapAngle(Target() - heading);
  const double to_go = run_.side == Side::kPort ? -left : left;
  // More than this to go the one way is a little too far the other way.
  constexpr double kRoundabout = 170.0 / 180.0 * std::numbers::pi;
  return std::abs(left) < params_.threshold.value() || to_go <= 0.0 || to_go > kRoundabout;
}

void BHV_ZigZag::Turn(Side side, const VehicleState& state, ActList& acts) {
  run_.side = side;
  if (IsDone()) return;
  acts.Raise(side == Side::kPort ? params_.port_flags : params_.starboard_flags, *this, state);
}

void BHV_ZigZag::FinishLeg(const VehicleState& state, ActList& acts) {
  ++run_.legs;
  ++run_.legs_ever;
  const bool is_pair = run_.legs % 2 == 0;
  const bool was_port = run_.side == Side::kPort;
  acts.Raise(params_.zig_flags, *this, state);
  if (is_pair) acts.Raise(params_.zag_flags, *this, state);
  acts.Raise(was_port ? params_.port_end_flags : params_.starboard_end_flags, *this, state);
  Turn(was_port ? Side::kStarboard : Side::kPort, state, acts);
  run_.leg_odo = 0.0;
  if (is_pair) run_.pair_odo = 0.0;
  run_.leg_begin_speed = state.speed();
  run_.least_speed.reset();
}

MotionBid BHV_ZigZag::Move(const VehicleState& state) {
  MotionBid bid;
  if (run_.is_over) return bid;
  ActList acts;
  Travel(state);
  if (run_.side == Side::kStem) {
    Turn(params_.begins_to_port ? Side::kPort : Side::kStarboard, state, acts);
  } else if (HasTurned(state.nav.yaw)) {
    FinishLeg(state, acts);
  }
  run_.is_over = IsDone();
  if (run_.is_over) {
    acts.Complete();
  } else {
    Draw(state, true, acts);
    constexpr double kSlowValue = 0.85;
    bid.course = Peak{.summit = Steered(state.nav.yaw),
                      .flat_half_width = 0.0,
                      .base_half_width = std::numbers::pi,
                      .share = kCoupledShare};
    bid.table = uneven_speed_.Around(
        {.speed = run_.speed, .slow_value = kSlowValue, .share = kCoupledShare}, state.domain);
  }
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_ZigZag::Stop(const VehicleState& state) {
  ActList acts;
  Draw(state, false, acts);
  return acts.Take();
}

void BHV_ZigZag::Draw(const VehicleState& state, bool is_active, ActList& acts) const {
  constexpr double kShown = 20.0;  // [m]
  const VisualHints& hints = params_.hints;
  const auto line = [&](const char* label, double heading, const std::string& color) {
    const MapPoint at = state.place();
    acts.Draw(std::vector{HeadingLine(label + std::string(state.ownship),
                                      {at, Project(at, {.bearing = heading, .distance = kShown})},
                                      color, is_active)});
  };
  if (IsDrawn(hints, "draw_set_hdg")) {
    line("zig_set_", Target(), hints.Text("set_hdg_color", "white"));
  }
  if (IsDrawn(hints, "draw_req_hdg")) {
    line("zig_req_", Steered(state.nav.yaw), hints.Text("req_hdg_color", "yellow"));
  }
}

std::optional<std::string> BHV_ZigZag::Macro(std::string_view name,
                                             const VehicleState& state) const {
  const auto count = [](int number) { return fmt::format("{}", number); };
  const double along = Stem().Along(state.place());
  const int legs_left = std::max(0, params_.legs - run_.legs);
  if (name == "ODO") return MacroNumber(run_.odo);
  if (name == "ZIG_ODO") return MacroNumber(run_.leg_odo);
  if (name == "ZAG_ODO") return MacroNumber(run_.pair_odo);
  if (name == "STEM_DIST") return MacroNumber(DistanceBetween(Stem().At(along), state.place()));
  if (name == "STEM_ODO") return MacroNumber(std::abs(along));
  if (name == "STEM_HDG") return MacroNumber(MoosHeadingFromYaw(run_.stem));
  if (name == "STEM_SPD") return MacroNumber(run_.begin_speed);
  if (name == "ZIGS") return count(run_.legs);
  if (name == "ZAGS") return count(run_.legs / 2);
  if (name == "ZIGS_EVER") return count(run_.legs_ever);
  if (name == "ZAGS_EVER") return count(run_.legs_ever / 2);
  if (name == "ZIGS_TOGO") return count(legs_left);
  if (name == "ZAGS_TOGO") return count((legs_left + 1) / 2);
  const double least = run_.least_speed.value_or(state.speed());
  if (name == "ZIG_START_SPD") return MacroNumber(run_.leg_begin_speed);
  if (name == "ZIG_MIN_SPD") return MacroNumber(least);
  if (name == "ZIG_SPD_DELTA") return MacroNumber(run_.leg_begin_speed - least);
  if (name == "ZIG_PORT") return run_.side == Side::kPort ? "true" : "false";
  if (name == "ZIG_STAR") return run_.side == Side::kStarboard ? "true" : "false";
  if (name == "ZIG_SIDE") {
    return run_.side == Side::kPort ? "port" : run_.side == Side::kStarboard ? "star" : "stem";
  }
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_ZigZag);

}  // namespace limpet
