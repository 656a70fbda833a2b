// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Waypoint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/heard_conditions.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using Step = WaypointProgress::Step;

std::string Whole(double value) { return fmt::format("{:.0f}", value); }

}  // namespace

BHV_Waypoint::BHV_Waypoint(Params params) : params_(std::move(params)) { SetPoints(params_); }

void BHV_Waypoint::SetPoints(const Params& params) {
  travel_ = {};
  travel_.progress.SetPoints(params.points);
  travel_.progress.SetRepeats(params.repeats);
  if (params.added) travel_.progress.Append(*params.added);
  travel_.is_reversed = params.order != "normal";
  if (travel_.is_reversed) travel_.progress.Reverse();
  travel_.is_greedy_due = params.is_greedy;
  if (params.index) travel_.progress.SetIndex(static_cast<std::size_t>(*params.index));
}

std::vector<std::string> BHV_Waypoint::Variables() const {
  std::vector<std::string> names;
  for (const Condition& condition : params_.lead_conditions) {
    std::ranges::move(condition.Variables(), std::back_inserter(names));
  }
  return names;
}

bool BHV_Waypoint::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_Waypoint&>(former);
  const bool has_new_points = HasKey(keys, {"points", "polygon", "point"});
  if (has_new_points) {
    travel_.progress.CountOn(old.travel_.progress);
    travel_.odometer = old.travel_.odometer;
  } else {
    const Travel fresh = std::exchange(travel_, old.travel_);
    WaypointProgress& progress = travel_.progress;
    const auto& points = params_.points;
    if (HasKey(keys, {"xpoints"}) && points.size() == progress.points().size()) {
      progress.MovePoints(fresh.progress.points());
    }
    if (HasKey(keys, {"newpt"}) && params_.added) progress.Append(*params_.added);
    if (HasKey(keys, {"greedy_tour", "shortest_tour"})) travel_.is_greedy_due = params_.is_greedy;
    const bool reverses =
        params_.order == "toggle" ? !travel_.is_reversed : params_.order == "reverse";
    if (HasKey(keys, {"order"}) && reverses != travel_.is_reversed) {
      travel_.is_reversed = reverses;
      progress.Reverse();
    }
  }
  if (CruiseSpeed() != old.CruiseSpeed()) travel_.odometer.Spoil();
  travel_.progress.SetRepeats(params_.repeats);
  if (HasKey(keys, {"currix"}) && params_.index) {
    travel_.progress.SetIndex(static_cast<std::size_t>(*params_.index));
  }
  return true;
}

void BHV_Waypoint::TakeStart(const VehicleState& state) {
  if (params_.points_from == "start" && travel_.progress.points().empty()) {
    travel_.progress.SetPoints({state.place()});
  }
}

void BHV_Waypoint::Start(const VehicleState&) {
  travel_.progress.ForgetApproach();
  travel_.odometer.Pause();
}

std::vector<BehaviorAct> BHV_Waypoint::Idle(const VehicleState& state) {
  TakeStart(state);
  return {};
}

std::vector<BehaviorAct> BHV_Waypoint::Stop(const VehicleState& state) {
  ActList acts;
  if (!travel_.progress.points().empty()) {
    acts.Draw(Drawing(state).Erase(travel_.progress.points(), travel_.progress.next()));
    if (params_.is_reset_on_idle) travel_.progress.Restart();
  }
  acts.Post(params_.previous_distance_variable, -1.0);
  acts.Post(params_.next_distance_variable, -1.0);
  return acts.Take();
}

MapPoint BHV_Waypoint::SteeringPoint(const VehicleState& state) {
  const WaypointProgress& progress = travel_.progress;
  if (params_.lead.lead <= 0.0 || !HoldAll(params_.lead_conditions, state)) {
    return progress.next();
  }
  std::optional<MapPoint> from;
  if (progress.index() > 0) {
    from = progress.points()[progress.index() - 1];
  } else if (progress.cycles() > 0) {
    from = progress.points().back();
  } else if (params_.leads_to_start) {
    travel_.begin = travel_.begin.value_or(state.place());
    from = travel_.begin;
  }
  return from ? LeadPoint({*from, progress.next()}, state.place(), params_.lead) : progress.next();
}

double BHV_Waypoint::CruiseSpeed() const {
  return params_.uses_alt_speed && params_.speed_alt ? params_.speed_alt->value()
                                                     : params_.speed.value();
}

double BHV_Waypoint::Speed(const MapPoint& at) const {
  const double cruise = CruiseSpeed();
  const std::optional<double> left = travel_.progress.ToEnd(at);
  if (params_.slow_distance <= 0.0 || !left || *left >= params_.slow_distance) {
    return cruise;
  }
  const double range = params_.slow_distance - params_.stop_distance;
  return *left <= params_.stop_distance ? 0.0 : cruise * (*left - params_.stop_distance) / range;
}

/// The way to go, and a fifth as much for the present course: where another behavior makes two ways
/// as good, it does not go to and fro between them. MOOS-IvP's helm scales what both come to
/// together, from the worst course to the best, to the course's share.
void BHV_Waypoint::BidOnCourse(double bearing, const VehicleState& state, MotionBid& bid) const {
  constexpr double kPresent = 0.2;
  const Peak present{.summit = state.nav.yaw,
                     .flat_half_width = std::numbers::pi / 6.0,
                     .base_half_width = std::numbers::pi * 7.0 / 6.0,
                     .edge_value = 0.75};
  const double off = std::abs(WrapAngle(bearing - state.nav.yaw));
  const double best = 1.0 + kPresent * PeakValue(present, off);
  const double worst = kPresent * PeakValue(present, std::numbers::pi - off);
  const double share = params_.patience / 100.0 / (best - worst);
  bid.course = Peak{.summit = bearing,
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = share};
  bid.present_course = present;
  bid.present_course->share = kPresent * share;
}

/// As much to say between the domain's best and worst speed as its share is, as MOOS-IvP has it:
/// a narrow domain makes it no less sure.
void BHV_Waypoint::BidOnSpeed(double speed, const VehicleState& state, MotionBid& bid) {
  const double share = 1.0 - params_.patience / 100.0;
  if (params_.function_kind == "zaic_spd") {
    bid.table = uneven_speed_.Around({.speed = speed, .share = share}, state.domain);
    return;
  }
  constexpr double kSkirt = 1.6;  // [m/s] besides half the speed
  constexpr double kEdge = 0.8;   // left of the preference at half the speed
  Peak peak{.summit = speed,
            .flat_half_width = 0.5 * speed,
            .base_half_width = 0.5 * speed + kSkirt,
            .edge_value = kEdge,
            .share = share};
  if (const auto& axis = state.domain.speed) {
    const double best = PeakValue(peak, std::clamp(speed, axis->low, axis->high) - speed);
    const double worst =
        std::min(PeakValue(peak, axis->low - speed), PeakValue(peak, axis->high - speed));
    if (best > worst) peak.share = share / (best - worst);
  }
  bid.speed = peak;
}

void BHV_Waypoint::Bid(double bearing, const VehicleState& state, MotionBid& bid) {
  const double speed = Speed(state.place());
  if (params_.function_kind == "roc" || params_.function_kind == "rate_of_closure") {
    bid.table = closure_.Toward({.bearing = bearing, .speed = speed}, state.domain);
    return;
  }
  BidOnCourse(bearing, state, bid);
  BidOnSpeed(speed, state, bid);
}

MotionBid BHV_Waypoint::Move(const VehicleState& state) {
  TakeStart(state);
  WaypointProgress& progress = travel_.progress;
  if (progress.points().empty()) {
    return {};
  }
  const MapPoint at = state.place();
  if (std::exchange(travel_.is_greedy_due, false)) {
    progress.SetPoints(GreedyTour(progress.points(), at));
  }
  ActList acts;
  const Step step = progress.Advance(at, params_.capture);
  travel_.odometer.Move(at);
  if (params_.measures_efficiency && step != Step::kUnderway) PostEfficiency(state, acts);
  acts.Post(With("WPT_ODO"), travel_.odometer.travelled_m());
  PostProgress(step, state, acts);
  MotionBid bid;
  if (step == Step::kCompleted) {
    acts.Draw(Drawing(state).Erase(progress.points(), progress.next()));
    progress.Restart();
  } else {
    PostStatus(state, acts);
    const MapPoint steering = SteeringPoint(state);
    acts.Draw(Drawing(state).Draw(progress.points(), progress.next(), steering));
    Bid(BearingTo(at, steering), state, bid);
  }
  bid.acts = acts.Take();
  return bid;
}

void BHV_Waypoint::PostProgress(Step step, const VehicleState& state, ActList& acts) {
  const bool is_round = step == Step::kCycled || step == Step::kCompleted;
  if (is_round) {
    acts.Post(With(params_.status_variable),
              fmt::format("behavior-name={},{}", name(),
                          step == Step::kCompleted ? "completed" : "cycled"));
    acts.RaiseAgain(params_.cycle_flags, *this, state);
  }
  if (step == Step::kCompleted) acts.Complete();
  const bool begins = params_.has_flags_on_start && !travel_.has_raised_flags;
  if (step != Step::kUnderway || begins) {
    acts.Raise(params_.waypoint_flags, *this, state);
    travel_.has_raised_flags = true;
  }
  const int cycles = travel_.progress.cycles();
  if (travel_.posted_cycles.value_or(0) != cycles) {
    acts.Post(With(params_.cycle_variable), static_cast<double>(cycles));
    travel_.posted_cycles = cycles;
  }
}

void BHV_Waypoint::PostEfficiency(const VehicleState& state, ActList& acts) {
  LegOdometer& odometer = travel_.odometer;
  // By `speed` also where speed_alt is in use, as MOOS-IvP has it.
  if (!odometer.Reach(state.place(), state.now, params_.speed.value())) return;
  const auto post = [&](const std::string& which, const LegSums& sums) {
    acts.Post(With("WPT_EFF_DIST_" + which), sums.DistanceEfficiency());
    acts.Post(With("WPT_EFF_TIME_" + which), sums.TimeEfficiency());
    acts.Post(
        With("WPT_EFF_SUMM_" + which),
        fmt::format("vname={}, bhv_name={}, linear_dist={}, odo_dist={}, efficiency_dist={}, "
                    "linear_time={}, odo_time={}, efficiency_time={}",
                    state.ownship, name(), DecimalText(sums.straight_m, 1),
                    DecimalText(sums.travelled_m, 1), DecimalText(sums.DistanceEfficiency(), 3),
                    DecimalText(sums.straight_s, 1), DecimalText(sums.travelled_s, 1),
                    DecimalText(sums.TimeEfficiency(), 3)));
  };
  post("LEG", odometer.leg());
  post("ALL", odometer.all());
}

void BHV_Waypoint::PostStatus(const VehicleState& state, ActList& acts) {
  const WaypointProgress& progress = travel_.progress;
  const MapPoint at = state.place();
  const double distance = DistanceBetween(at, progress.next());
  acts.Post(
      With(params_.status_variable),
      fmt::format("vname={},behavior-name={},index={},hits={}/{},cycles={},dist={},eta={}",
                  state.ownship, name(), progress.index(), progress.captures(), progress.hits(),
                  progress.cycles(), Whole(distance), Whole(distance / state.speed())));
  if (travel_.posted_index != progress.index()) {
    acts.Post(With(params_.index_variable), static_cast<double>(progress.index()));
    travel_.posted_index = progress.index();
  }
  const auto& previous = progress.previous();
  acts.Post(params_.previous_distance_variable, previous ? DistanceBetween(at, *previous) : -1.0);
  acts.Post(params_.next_distance_variable, distance);
}

WayDrawing BHV_Waypoint::Drawing(const VehicleState& state) const {
  return {.vehicle = std::string(state.ownship), .behavior = name(), .hints = params_.hints};
}

std::string BHV_Waypoint::With(const std::string& variable) const {
  const bool is_silent = variable.empty() || EqualsIgnoringCase(variable, "silent");
  return is_silent ? "" : variable + params_.suffix;
}

std::optional<std::string> BHV_Waypoint::Macro(std::string_view name,
                                               const VehicleState& state) const {
  const WaypointProgress& progress = travel_.progress;
  const auto count = [](auto number) { return fmt::format("{}", number); };
  if (name == "POINTS") return "pts={" + PointsText(progress.points()) + "}";
  if (name == "SPEED") return MacroNumber(params_.speed.value());
  if (name == "SPEED_ALT")
    return MacroNumber(params_.speed_alt.value_or(MetersPerSecond(-1.0)).value());
  if (name == "USE_SPEED_ALT") return params_.uses_alt_speed ? "1" : "0";
  if (name == "WPT_FLAG_ON_START") return params_.has_flags_on_start ? "1" : "0";
  if (name == "LEAD_TO_START") return params_.leads_to_start ? "1" : "0";
  if (name == "IPF_TYPE") return params_.function_kind;
  if (name == "LEAD_DAMPER") return MacroNumber(params_.lead.damper);
  if (name == "ORDER") return travel_.is_reversed ? "reverse" : "normal";
  if (name == "CYCLES") return count(progress.cycles());
  if (name == "CYCREM") return count(progress.repeats_left().value_or(0));
  if (name == "WPTS_HIT") return count(progress.hits());
  if (name == "WPTS") return count(progress.points().size());
  if (name == "WPTS_REM") return count(progress.points().size() - progress.index());
  if (name == "NI" || name == "IX") return count(progress.index());
  if (progress.points().empty()) return std::nullopt;
  if (name == "NX") return MacroNumber(progress.next().x);
  if (name == "NY") return MacroNumber(progress.next().y);
  const MapPoint at = state.place();
  const MapPoint previous = progress.previous().value_or(at);
  if (name == "PX" || name == "X") return MacroNumber(previous.x);
  if (name == "PY" || name == "Y") return MacroNumber(previous.y);
  if (name == "PI") return progress.previous_index() ? count(*progress.previous_index()) : "-1";
  if (name == "CYC_DIST_TOGO") return MacroNumber(progress.ToEndOfCycle(at));
  if (name == "ALL_DIST_TOGO") return MacroNumber(progress.ToEnd(at).value_or(-1.0));
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_Waypoint);

}  // namespace limpet
