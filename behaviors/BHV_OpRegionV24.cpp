// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegionV24.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/heard_altitude.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/topics/warning.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/point_list.hpp"
#include "limpet/waypoints/ray_approach.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

const WarningId kCoreRefused = DeclareWarning(
    "REGION_REFUSED",
    {.severity = Severity::kWarning,
     .raised_by = {"BHV_OpRegionV24"},
     .meaning = "Mail of dynamic_region_var is no convex polygon: the region is where it was.",
     .action = "Look at what writes that variable.",
     .clears = "With mail that is one, or when the behavior runs no more."});

/// The polygon so far about `core`, or `otherwise`; throws ConfigError if there is no core.
std::optional<ConvexPolygon> About(const std::optional<ConvexPolygon>& core,
                                   const std::optional<double>& distance, const char* key,
                                   const std::optional<ConvexPolygon>& otherwise) {
  if (!distance) return otherwise;
  if (!core) throw ConfigError(ConfigProblem{{}, key, "needs `core_poly`, which it is about"});
  return *distance > 0.0 ? ConvexPolygon::Of(BufferedCorners(*core, *distance)) : core;
}

std::optional<std::string> CornersText(const std::optional<ConvexPolygon>& polygon) {
  return polygon ? std::optional(PointsText(polygon->corners())) : std::nullopt;
}

/// How long it has been so, or 0 [s].
std::string SecondsSince(const std::optional<Seconds>& since, Seconds now) {
  return MacroNumber(since ? (now - *since).value() : 0.0);
}

/// What is left below a limit, in whole metres.
std::string WholeLeft(double left) {
  return fmt::format("{:.0f}", std::floor(std::max(0.0, left)));
}

}  // namespace

BHV_OpRegionV24::BHV_OpRegionV24(const Params& params)
    : params_(params),
      save_(About(params.core, params.save_distance, "save_dist", params.save)),
      halt_(About(params.core, params.halt_distance, "halt_dist", params.halt)) {}

std::vector<std::string> BHV_OpRegionV24::Variables() const {
  std::vector<std::string> names;
  if (params_.least_altitude) names.emplace_back("NAV_ALTITUDE");
  for (const std::string* variable : {&params_.reset_variable, &params_.core_variable}) {
    if (!variable->empty()) names.push_back(*variable);
  }
  return names;
}

bool BHV_OpRegionV24::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_OpRegionV24&>(former);
  reset_at_ = old.reset_at_;
  // Mail that moved the core is heard once more, unless the update has another.
  if (HasKey(keys, {"core_poly"})) core_at_ = old.core_at_;
  if (!HasKey(keys, {"reset"}) || !params_.is_reset) watch_ = old.watch_;
  return true;
}

void BHV_OpRegionV24::Begin(const VehicleState& state) {
  const Stamped<limpet::Value>* heard =
      params_.reset_variable.empty() ? nullptr : state.Heard(params_.reset_variable);
  if (heard != nullptr && reset_at_ != heard->time) {
    reset_at_ = heard->time;
    const auto* text = std::get_if<std::string>(&heard->value);
    if (text != nullptr && EqualsIgnoringCase(*text, "true")) watch_ = {};
  }
  watch_.began = watch_.began.value_or(state.now);
  HearCore(state);
}

void BHV_OpRegionV24::HearCore(const VehicleState& state) {
  const Stamped<limpet::Value>* heard =
      params_.core_variable.empty() ? nullptr : state.Heard(params_.core_variable);
  const auto* text = heard == nullptr ? nullptr : std::get_if<std::string>(&heard->value);
  if (text == nullptr || core_at_ == heard->time) return;
  core_at_ = heard->time;
  auto corners = ParsePoints(*text);
  auto core = corners ? ConvexPolygon::Of(*std::move(corners)) : std::nullopt;
  is_core_refused_ = !core;
  if (!core) return;  // the former one goes on, and that is said
  params_.core = std::move(core);
  save_ = About(params_.core, params_.save_distance, "save_dist", params_.save);
  halt_ = About(params_.core, params_.halt_distance, "halt_dist", params_.halt);
}

void BHV_OpRegionV24::TellTimeLeft(const VehicleState& state, ActList& acts) const {
  if (params_.time_variable.empty()) return;
  if (!params_.longest) {
    acts.Post(params_.time_variable, -1.0);
    return;
  }
  constexpr double kExactBelow = 10.0;  // [s] before that whole seconds do
  const Seconds left = *params_.longest - (state.now - *watch_.began);
  const double seconds = std::max(0.0, left.value());
  acts.Post(params_.time_variable, seconds > kExactBelow ? std::floor(seconds) : seconds);
}

void BHV_OpRegionV24::GiveUp(const VehicleState& state, ActList& acts) {
  acts.Raise(params_.poly_flags, *this, state);
  acts.Repeat("MOOS_MANUAL_OVERRIDE", std::string("true"));
  watch_.entered_halt.reset();
  watch_.left_halt.reset();
  watch_.was_in_halt = false;
}

std::vector<BehaviorAct> BHV_OpRegionV24::Idle(const VehicleState& state) {
  ActList acts;
  Begin(state);
  TellTimeLeft(state, acts);
  return acts.Take();
}

void BHV_OpRegionV24::Guard(bool is_breached, const std::string& reason,
                            const std::vector<Flag>& flags, bool& was_breached,
                            const VehicleState& state, ActList& acts) {
  if (is_breached && !was_breached) acts.Raise(flags, *this, state);
  if (is_breached) acts.Halt(reason);
  was_breached = is_breached;
}

void BHV_OpRegionV24::GuardLimits(const VehicleState& state, ActList& acts) {
  if (params_.deepest) {
    const double deepest = params_.deepest->value();
    Guard(state.nav.down > deepest, fmt::format("it is deeper than max_depth, {:g} m", deepest),
          params_.depth_flags, watch_.breaches_depth, state, acts);
  }
  if (params_.least_altitude) {
    const double least = params_.least_altitude->value();
    const std::optional<double> altitude = AltitudeOf(state);
    if (!altitude) acts.Halt("nobody says how high it is above the seabed");
    Guard(altitude && *altitude < least,
          fmt::format("it is nearer to the seabed than min_altitude, {:g} m", least),
          params_.altitude_flags, watch_.breaches_altitude, state, acts);
  }
  if (params_.longest) {
    Guard(state.now - *watch_.began > *params_.longest,
          fmt::format("max_time, {:g} s, is over", params_.longest->value()), params_.time_flags,
          watch_.breaches_time, state, acts);
  }
}

void BHV_OpRegionV24::GuardHalt(const VehicleState& state, ActList& acts) {
  if (!halt_) return;
  const bool is_inside = halt_->Contains(state.place());
  (is_inside ? watch_.left_halt : watch_.entered_halt).reset();
  std::optional<Seconds>& since = is_inside ? watch_.entered_halt : watch_.left_halt;
  since = since.value_or(state.now);
  const Seconds passed = state.now - *since;
  if (is_inside && passed >= params_.entry_time) watch_.was_in_halt = true;
  const bool counts = watch_.was_in_halt || !params_.waits_for_entry;
  const bool is_breached = !is_inside && counts && passed >= params_.exit_time;
  if (is_breached && params_.is_soft) {
    GiveUp(state, acts);
    return;
  }
  Guard(is_breached, "it has left " + params_.halt_key, params_.poly_flags, watch_.breaches_poly,
        state, acts);
  if (params_.draws_halt && is_breached) {
    DrawStatus(state, "halt_status_edge_color", "red", true, acts);
  }
}

bool BHV_OpRegionV24::MustReturn(const VehicleState& state, ActList& acts) {
  if (!save_) return false;
  if (save_->Contains(state.place())) {
    watch_.was_in_save = true;
    watch_.left_save.reset();
    watch_.turn = Watch::Turn::kNone;
    return false;
  }
  if (!watch_.was_in_save) return false;
  if (!watch_.left_save) {
    watch_.left_save = state.now;
    acts.Raise(params_.save_flags, *this, state);
  }
  acts.Raise(params_.savex_flags, *this, state);
  if (params_.draws_save) DrawStatus(state, "save_status_edge_color", "yellow", true, acts);
  return true;
}

MotionBid BHV_OpRegionV24::Move(const VehicleState& state) {
  MotionBid bid;
  ActList acts;
  Begin(state);
  if (is_core_refused_) {
    bid.warning = BehaviorWarning{
        kCoreRefused, params_.core_variable + " is no convex polygon: the former one counts"};
  }
  if (!std::exchange(is_polygon_told_, true) && halt_) {
    acts.Post(params_.polygon_variable, "pts={" + PointsText(halt_->corners()) + "}");
  }
  TellTimeLeft(state, acts);
  Draw(state, true, acts);
  GuardLimits(state, acts);
  GuardHalt(state, acts);
  TellBorders(state, acts);
  if (MustReturn(state, acts)) {
    SteerBack(state, acts, bid);
  } else if (!watch_.breaches_poly) {
    EraseStatus(state, acts);
  }
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_OpRegionV24::Stop(const VehicleState& state) {
  ActList acts;
  Draw(state, false, acts);
  EraseStatus(state, acts);
  return acts.Take();
}

void BHV_OpRegionV24::Draw(const VehicleState& state, bool is_active, ActList& acts) const {
  const VisualHints& hints = params_.hints;
  const auto draw = [&](const std::string& what, const std::optional<ConvexPolygon>& polygon,
                        const char* color) {
    if (!polygon) return;
    acts.Draw(std::vector{
        DrawnTextOf({.label = fmt::format("opreg_{}_{}", what, state.ownship),
                     .form = PolygonShape{polygon->corners()},
                     .style = {.label_color = hints.Text(what + "_label_color", "off"),
                               .edge_color = hints.Text(what + "_edge_color", color),
                               .vertex_color = hints.Text(what + "_vertex_color", "gray50"),
                               .vertex_size = hints.Number(what + "_vertex_size", 0.0),
                               .edge_size = hints.Number(what + "_edge_size", 1.0)},
                     .is_active = is_active},
                    what)});
  };
  draw("core", params_.core, "gray30");
  draw("save", save_, "gray50");
  draw("halt", halt_, "pink");
}

void BHV_OpRegionV24::EraseStatus(const VehicleState& state, ActList& acts) const {
  if (save_ || halt_) DrawStatus(state, "", "off", false, acts);
}

void BHV_OpRegionV24::DrawStatus(const VehicleState& state, const std::string& hint,
                                 const char* color, bool is_active, ActList& acts) const {
  constexpr int kCorners = 12;
  constexpr double kRadius = 4.0;  // [m]
  PolygonShape ring;
  for (int i = 0; is_active && i < kCorners; ++i) {
    const double bearing = 2.0 * std::numbers::pi * i / kCorners;
    ring.corners.push_back(Project(state.place(), {.bearing = bearing, .distance = kRadius}));
  }
  if (!is_active) ring.corners.assign(3, MapPoint{});
  acts.Draw(std::vector{DrawnTextOf({.label = std::string(state.ownship) + "_stat",
                                     .form = std::move(ring),
                                     .style = {.label_color = "off",
                                               .edge_color = params_.hints.Text(hint, color),
                                               .vertex_color = "off",
                                               .vertex_size = 0.0,
                                               .edge_size = 1.0},
                                     .is_active = is_active},
                                    "stat")});
}

std::optional<std::string> BHV_OpRegionV24::Macro(std::string_view name,
                                                  const VehicleState& state) const {
  if (name == "CORE_POLY") return CornersText(params_.core);
  if (name == "SAVE_POLY") return CornersText(save_);
  if (name == "HALT_POLY") return CornersText(halt_);
  if (name == "SAVE_DIST") return MacroNumber(params_.save_distance.value_or(-1.0));
  if (name == "HALT_DIST") return MacroNumber(params_.halt_distance.value_or(-1.0));
  if (name == "SECS_IN_HALT_POLY") return SecondsSince(watch_.entered_halt, state.now);
  if (name == "SECS_OUT_HALT_POLY") return SecondsSince(watch_.left_halt, state.now);
  if (name == "SECS_OUT_SAVE_POLY") return SecondsSince(watch_.left_save, state.now);
  if (name == "TIME_LEFT" && params_.longest && watch_.began) {
    const Seconds left = *params_.longest - (state.now - *watch_.began);
    return MacroNumber(std::max(0.0, left.value()));
  }
  if (name == "DEPTH_LEFT" && params_.deepest) {
    return WholeLeft(params_.deepest->value() - state.nav.down);
  }
  if (name == "ALT_LEFT" && params_.least_altitude) {
    return WholeLeft(AltitudeOf(state).value_or(0.0) - params_.least_altitude->value());
  }
  return DistanceMacro(name, state);
}

LIMPET_REGISTER_BEHAVIOR(BHV_OpRegionV24);

}  // namespace limpet
