// SPDX-License-Identifier: MIT
// How far the borders of its polygons are, and the way back inside.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "behaviors/BHV_OpRegionV24.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/ray_approach.hpp"

namespace limpet {
namespace {

constexpr double kNowhere = -1.0;  // what is told of a border that is not on the way

/// Whole metres, but for the last one.
double WholeButLast(double distance) {
  return distance <= 1.0 ? distance : std::floor(distance + 0.5);
}

/// How long a way takes [s]; 0 for who stands.
double TimeFor(double distance, double speed) { return speed > 0.0 ? distance / speed : 0.0; }

double FastestOf(const VehicleState& state) {
  return state.domain.speed ? state.domain.speed->high : 0.0;
}

/// The least turn to where the polygon lies ahead, to starboard positive [rad]; from outside.
double LeastTurn(const ConvexPolygon& polygon, const VehicleState& state) {
  double least = std::numbers::pi;
  for (const MapPoint& corner : polygon.corners()) {
    const double turn = WrapAngle(BearingTo(state.place(), corner) - state.nav.yaw);
    if (std::abs(turn) < std::abs(least)) least = turn;
  }
  return least;
}

}  // namespace

void BHV_OpRegionV24::TellBorders(const VehicleState& state, ActList& acts) const {
  if (!params_.tells_borders) return;
  if (params_.longest) {
    const Seconds left = *params_.longest - (state.now - *watch_.began);
    acts.Post("OPREG_TIME_REMAINING", std::max(0.0, left.value()));
  }
  if (!halt_) {
    if (state.area) return;  // a survey's region has borders, which nobody asks for here
    for (const char* variable : {"OPREG_TRAJECTORY_PERIM_DIST", "OPREG_TRAJECTORY_PERIM_ETA",
                                 "OPREG_ABSOLUTE_PERIM_DIST", "OPREG_ABSOLUTE_PERIM_ETA"}) {
      acts.Post(variable, kNowhere);
    }
    acts.Post("SECS_IN_POLY", 0.0);
    return;
  }
  const double ahead = DistanceToBorder(*halt_, state.place(), state.nav.yaw).value_or(kNowhere);
  const double nearest = std::abs(halt_->Outside(state.place()));
  const auto whole = [](double seconds) { return std::trunc(seconds + 0.5); };
  acts.Post("OPREG_TRAJECTORY_PERIM_DIST", WholeButLast(ahead));
  acts.Post("OPREG_TRAJECTORY_PERIM_ETA", whole(TimeFor(ahead, state.speed())));
  acts.Post("OPREG_ABSOLUTE_PERIM_DIST", WholeButLast(nearest));
  acts.Post("OPREG_ABSOLUTE_PERIM_ETA", whole(TimeFor(nearest, FastestOf(state))));
  const Seconds inside = state.now - watch_.entered_halt.value_or(state.now);
  acts.Post("SECS_IN_POLY", inside.value());
}

void BHV_OpRegionV24::CommitTurn(const VehicleState& state, ActList& acts) {
  using Turn = Watch::Turn;
  if (DistanceToBorder(*save_, state.place(), state.nav.yaw)) {
    watch_.turn = Turn::kNone;
  } else if (watch_.turn == Turn::kNone) {
    watch_.turn = LeastTurn(*save_, state) > 0.0 ? Turn::kRight : Turn::kLeft;
  }
  acts.Repeat("COMMITTED", std::string(watch_.turn == Turn::kNone    ? "none"
                                       : watch_.turn == Turn::kRight ? "right"
                                                                     : "left"));
}

/// Straight in, as far as the core; where that lies astern, by the way round that it has begun.
void BHV_OpRegionV24::SteerBack(const VehicleState& state, ActList& acts, MotionBid& bid) {
  constexpr double kLeastSkirt = 0.2;                         // [m/s]
  constexpr double kTurn = 150.0 / 180.0 * std::numbers::pi;  // as long as it turns
  CommitTurn(state, acts);
  const ConvexPolygon& target = params_.core ? *params_.core : *save_;
  const double speed = params_.recover_speed.value();
  double course = BearingTo(state.place(), target.NearestOnBorder(state.place()));
  if (watch_.turn != Watch::Turn::kNone) {
    const double side = watch_.turn == Watch::Turn::kRight ? 1.0 : -1.0;
    const double turn = side * WrapAngle(course - state.nav.yaw);
    constexpr double kAstern = 1e-6 - std::numbers::pi;  // either way is as far
    if (turn < 0.0 && turn > kAstern) course = WrapAngle(state.nav.yaw + side * kTurn);
  }
  bid.course = Peak{.summit = course,
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = kCoupledShare};
  bid.speed = Peak{.summit = speed,
                   .flat_half_width = 0.0,
                   .base_half_width = std::max(kLeastSkirt, 0.5 * speed),
                   .share = kCoupledShare};
}

const ConvexPolygon* BHV_OpRegionV24::PolygonOf(std::string_view macro) const {
  const auto of = [](const std::optional<ConvexPolygon>& polygon) {
    return polygon ? &*polygon : nullptr;
  };
  if (macro.ends_with("_CORE")) return of(params_.core);
  if (macro.ends_with("_SAVE")) return of(save_);
  return macro.ends_with("_HALT") ? of(halt_) : nullptr;
}

/// DIST_TO_CORE, ETA_TO_SAVE and the like: to the polygon's border, at the fastest that the helm
/// may ask for; with TRAJ_ along the heading.
std::optional<std::string> BHV_OpRegionV24::DistanceMacro(std::string_view name,
                                                          const VehicleState& state) const {
  constexpr std::string_view kAhead = "TRAJ_";
  const bool is_ahead = name.starts_with(kAhead);
  if (is_ahead) name.remove_prefix(kAhead.size());
  const bool is_eta = name.starts_with("ETA_TO_");
  if (!is_eta && !name.starts_with("DIST_TO_")) return std::nullopt;
  const ConvexPolygon* polygon = PolygonOf(name);
  if (polygon == nullptr) return std::nullopt;
  const double distance =
      is_ahead ? DistanceToBorder(*polygon, state.place(), state.nav.yaw).value_or(kNowhere)
               : std::abs(polygon->Outside(state.place()));
  if (!is_eta || distance < 0.0) return MacroNumber(distance);
  const double fastest = FastestOf(state);
  return fastest > 0.0 ? std::optional(MacroNumber(distance / fastest)) : std::nullopt;
}

}  // namespace limpet
