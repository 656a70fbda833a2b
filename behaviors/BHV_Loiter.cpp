// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Loiter.hpp"

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
#include "limpet/topics/warning.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/point_list.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

const WarningId kNoLoiterPolygon =
    DeclareWarning("LOITER_NO_POLYGON",
                   {.severity = Severity::kWarning,
                    .raised_by = {"BHV_Loiter"},
                    .meaning = "The behavior runs and has no polygon to go round: it has no say.",
                    .action = "Give its block a polygon, or send one by its updates.",
                    .clears = "With the first polygon, or once the behavior does not run."});

MapPose PoseOf(const VehicleState& state) {
  return {.at = state.place(), .heading = state.nav.yaw};
}

/// Whole metres and seconds from ten on: posted when they change, and that is often enough.
double Coarse(double value) {
  constexpr double kFine = 10.0;
  return value > kFine ? std::round(value) : value;
}

/// What a corner ahead is preferred by: with 0 75 degrees, with 100 one.
double InertiaOf(double spiral_factor) {
  return RadiansFromDegrees(75.0 - 0.74 * std::clamp(spiral_factor, 0.0, 100.0));
}

}  // namespace

BHV_Loiter::BHV_Loiter(const Params& params) : params_(params) {
  rounds_.polygon = params_.polygon;
  rounds_.is_clockwise = params_.clockwise != "false";
  rounds_.progress.SetRepeats(std::nullopt);
  if (rounds_.polygon) {
    rounds_.polygon->Grow(params_.growth);
    AssignCenter({"center_assign", "xcenter_assign", "ycenter_assign"});
    LayCorners();
  }
}

bool BHV_Loiter::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_Loiter&>(former);
  const Rounds fresh = std::exchange(rounds_, old.rounds_);
  if (HasKey(keys, {"polygon"})) {
    rounds_.polygon = fresh.polygon;
    rounds_.is_acquiring = true;
  }
  if (HasKey(keys, {"mod_poly_rad"}) && rounds_.polygon) {
    rounds_.polygon->Grow(params_.growth);
    rounds_.is_acquiring = true;
    rounds_.mode = "idle";
  }
  if (HasKey(keys, {"clockwise"}) && params_.clockwise != "best") {
    rounds_.is_clockwise = params_.clockwise == "true";
  }
  if (rounds_.polygon) {
    AssignCenter(keys);
    const std::size_t index = rounds_.progress.index();
    LayCorners();
    if (!HasKey(keys, {"polygon", "clockwise"})) rounds_.progress.SetIndex(index);
  }
  return true;
}

void BHV_Loiter::AssignCenter(const std::vector<std::string>& keys) {
  MapPoint center = rounds_.polygon->Center();
  if (HasKey(keys, {"center_assign"})) {
    const std::string& text = params_.center_assign;
    rounds_.is_center_due = EqualsIgnoringCase(text, "present_position");
    if (const auto point = ParsePoint(text)) {
      center = *point;
    } else if (text.starts_with("x=")) {
      center.x = ParseNumber(text.substr(2)).value_or(center.x);
    } else if (text.starts_with("y=")) {
      center.y = ParseNumber(text.substr(2)).value_or(center.y);
    }
  }
  if (HasKey(keys, {"xcenter_assign"})) center.x = params_.center_x.value_or(center.x);
  if (HasKey(keys, {"ycenter_assign"})) center.y = params_.center_y.value_or(center.y);
  rounds_.polygon->MoveTo(center);
}

void BHV_Loiter::LayCorners() {
  std::vector<MapPoint> corners = rounds_.polygon->corners();
  if (!rounds_.is_clockwise) std::ranges::reverse(corners);
  rounds_.progress.SetPoints(std::move(corners));
}

void BHV_Loiter::Enter(const MapPose& vehicle) {
  const std::size_t corner = EntryCorner(*rounds_.polygon, rounds_.is_clockwise, vehicle,
                                         InertiaOf(params_.spiral_factor));
  // The rounds' own order is the polygon's, or its reverse.
  const std::size_t count = rounds_.polygon->corners().size();
  rounds_.progress.SetIndex(rounds_.is_clockwise ? corner : count - 1 - corner);
}

void BHV_Loiter::Start(const VehicleState& state) {
  if (!rounds_.polygon) return;
  if (params_.is_center_activated || std::exchange(rounds_.is_center_due, false)) {
    rounds_.polygon->MoveTo(state.place());
  }
  const MapPose vehicle = PoseOf(state);
  // The best way round is looked for as it wakes up, not as the helm begins with it.
  if (params_.clockwise == "best" && rounds_.has_been_idle &&
      !rounds_.polygon->Contains(vehicle.at)) {
    rounds_.is_clockwise = IsClockwiseBest(*rounds_.polygon, vehicle);
  }
  LayCorners();
  Enter(vehicle);
  rounds_.last_bearing.reset();
  rounds_.swept = 0.0;
}

void BHV_Loiter::BidOnSpeed(double speed, const VehicleState& state, MotionBid& bid) {
  constexpr double kSkirt = 0.3;       // [m/s]
  constexpr double kSlowValue = 0.85;  // of zaic_spd, at 0.1 m/s
  const double share = 1.0 - params_.patience / 100.0;
  if (params_.prefers_slower) {
    bid.table = uneven_speed_.Around({.speed = speed, .slow_value = kSlowValue, .share = share},
                                     state.domain);
  } else {
    bid.speed =
        Peak{.summit = speed, .flat_half_width = 0.0, .base_half_width = kSkirt, .share = share};
  }
}

void BHV_Loiter::SetMode(double outside) {
  const double far = params_.acquire_distance.value();
  std::string& mode = rounds_.mode;
  const char* side = outside > far ? "external" : outside < -far ? "internal" : nullptr;
  if (side == nullptr) {
    mode = "stable";
    return;
  }
  const bool was_there = mode == "stable" || mode == std::string("recovering_") + side;
  mode = std::string(was_there ? "recovering_" : "acquiring_") + side;
}

void BHV_Loiter::Complete(const VehicleState&) {
  rounds_.is_completion_due = true;
  rounds_.last_bearing.reset();
  rounds_.swept = 0.0;
}

void BHV_Loiter::TellCompletion(ActList& acts) {
  if (std::exchange(rounds_.is_completion_due, false)) acts.Post("LOITER_COMPLETE", "true");
}

bool BHV_Loiter::IsSlungRound(const MapPoint& at, ActList& acts) {
  if (!params_.slingshot || rounds_.is_acquiring) return false;
  const double bearing = BearingTo(at, rounds_.polygon->Center());
  if (rounds_.last_bearing) {
    const double step = std::abs(WrapAngle(bearing - *rounds_.last_bearing));
    rounds_.swept += step;
    acts.Post("LOITER_BNG_TOTAL", DegreesFromRadians(rounds_.swept));
    acts.Post("LOITER_BNG_DELTA", DegreesFromRadians(step));
  }
  rounds_.last_bearing = bearing;
  return rounds_.swept > params_.slingshot->value();
}

MotionBid BHV_Loiter::Move(const VehicleState& state) {
  MotionBid bid;
  if (!rounds_.polygon) {
    bid.warning = BehaviorWarning{kNoLoiterPolygon, "there is no polygon to go round"};
    return bid;
  }
  const MapPose vehicle = PoseOf(state);
  if (std::exchange(rounds_.is_center_due, false)) {
    rounds_.polygon->MoveTo(vehicle.at);
    LayCorners();
  }
  const double outside = rounds_.polygon->Outside(vehicle.at);
  SetMode(outside);
  rounds_.is_acquiring = outside > params_.acquire_distance.value();
  if (rounds_.is_acquiring) Enter(vehicle);
  ActList acts;
  TellCompletion(acts);
  const bool is_done = IsSlungRound(vehicle.at, acts);
  if (rounds_.progress.Advance(vehicle.at, params_.capture) != WaypointProgress::Step::kUnderway) {
    rounds_.is_acquiring = false;
  }
  const MapPoint& next = rounds_.progress.next();
  acts.Post("LOITER_DIST_TO_VERT", DistanceBetween(vehicle.at, next));
  Draw(state, true, acts);
  PostStatus(state, acts);
  if (is_done) acts.Complete("slingshot");
  const double speed = params_.uses_alt_speed && params_.speed_alt ? params_.speed_alt->value()
                                                                   : params_.speed.value();
  bid.course = Peak{.summit = BearingTo(vehicle.at, next),
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = params_.patience / 100.0};
  BidOnSpeed(speed, state, bid);
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_Loiter::Ended(const VehicleState& state) {
  ActList acts;
  TellCompletion(acts);
  rounds_.mode = "idle";
  if (rounds_.polygon) {
    Draw(state, false, acts);
    PostStatus(state, acts);
  }
  return acts.Take();
}

std::vector<BehaviorAct> BHV_Loiter::Stop(const VehicleState& state) { return Ended(state); }

std::vector<BehaviorAct> BHV_Loiter::Idle(const VehicleState& state) {
  rounds_.has_been_idle = true;
  return Ended(state);
}

void BHV_Loiter::PostStatus(const VehicleState& state, ActList& acts) const {
  const WaypointProgress& progress = rounds_.progress;
  const auto with = [this](const char* variable) { return variable + params_.suffix; };
  const double outside = rounds_.polygon->Outside(state.place());
  const double eta = outside > 0.0 && state.speed() > 0.0 ? outside / state.speed() : 0.0;
  acts.Post(
      with("LOITER_REPORT"),
      fmt::format("index={},capture_hits={},nonmono_hits={},acquire_mode={}", progress.index(),
                  progress.captures(), progress.slips(), rounds_.is_acquiring ? "true" : "false"));
  acts.Post(with("LOITER_INDEX"), static_cast<double>(progress.index()));
  acts.Post(with("LOITER_MODE"), rounds_.mode);
  acts.Post(with("LOITER_ACQUIRE"), rounds_.is_acquiring ? 1.0 : 0.0);
  acts.Post(with("LOITER_DIST_TO_POLY"), Coarse(outside));
  acts.Post(with("LOITER_ETA_TO_POLY"), Coarse(eta));
}

void BHV_Loiter::Draw(const VehicleState& state, bool is_active, ActList& acts) const {
  const std::string ownship(state.ownship);
  acts.Draw(RingDrawing{.vehicle = ownship, .behavior = name(), .hints = params_.hints}.Draw(
      rounds_.progress.points(), rounds_.progress.next(), is_active));
}

std::optional<std::string> BHV_Loiter::Macro(std::string_view macro, const VehicleState&) const {
  if (!rounds_.polygon) return std::nullopt;
  const MapPoint center = rounds_.polygon->Center();
  if (macro == "PTS") return MacroNumber(static_cast<double>(rounds_.polygon->corners().size()));
  if (macro == "CX") return MacroNumber(center.x);
  if (macro == "CY") return MacroNumber(center.y);
  if (macro == "CENTER") return "x=" + MacroNumber(center.x) + ",y=" + MacroNumber(center.y);
  if (macro == "CWISE") return rounds_.is_clockwise ? "1" : "0";
  if (macro == "RAD") return MacroNumber(rounds_.polygon->Radius());
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_Loiter);

}  // namespace limpet
