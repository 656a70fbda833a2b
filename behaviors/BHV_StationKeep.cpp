// SPDX-License-Identifier: MIT
#include "behaviors/BHV_StationKeep.hpp"

#include <algorithm>
#include <numbers>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/topics/warning.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

const WarningId kNoStation =
    DeclareWarning("STATION_POINT_NOT_SET",
                   {.severity = Severity::kWarning,
                    .raised_by = {"BHV_StationKeep"},
                    .meaning = "The behavior runs and knows no station: it has no say.",
                    .action = "Give its block a station_pt, or center_activate = true.",
                    .clears = "With the first station, or once the behavior does not run."});

constexpr Seconds kRemembered(10.0);  ///< distances older than that are forgotten
constexpr Seconds kEnough(5.0);       ///< over less no drift can be told
constexpr double kNoNearer = -0.02;   ///< [m/s] the last metres are approached ever more slowly

}  // namespace

void BHV_StationKeep::Params::Describe(ParamCollector& visit) {
  visit.Parsed("station_pt", "x,y", "Where: x east, y north of the datum [m]", "",
               [this](std::string_view text) {
                 station = ParsePoint(text);
                 return text.empty() || station.has_value();
               });
  visit.Also({"point"});
  visit("center_activate", is_center_activated, "Stay where it is, whenever it begins to run");
  visit("swing_time", swing_time, "With that, the station moves along for so long at first",
        InRange(Seconds(0.0), Seconds(60.0)));
  visit.Clipped();
  visit("inner_radius", inner_radius, "Nearer than this it stops",
        InRange(Meters(1e-3), Meters(1e5)));
  visit("outer_radius", outer_radius, "From here on it hurries",
        InRange(Meters(1e-3), Meters(1e5)));
  visit("outer_speed", outer_speed, "Speed at outer_radius; less nearer",
        InRange(MetersPerSecond(0.01), MetersPerSecond(100.0)));
  visit("transit_speed", transit_speed, "Speed beyond outer_radius",
        InRange(MetersPerSecond(0.01), MetersPerSecond(100.0)));
  visit.Also({"extra_speed"});
  visit.Parsed("hibernation_radius", "a number in m, or off",
               "Once there it stays idle until further off than this", "off",
               [this](std::string_view text) {
                 const auto radius = ParseNumber(text);
                 const bool is_off = EqualsIgnoringCase(text, "off") || radius == -1.0;
                 if (!is_off && (!radius || *radius <= 0.0)) return false;
                 hibernation_radius = is_off ? std::nullopt : std::optional(Meters(*radius));
                 return true;
               });
  DescribeHints(visit, hints);
}

bool BHV_StationKeep::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  watch_ = dynamic_cast<const BHV_StationKeep&>(former).watch_;
  if (!HasKey(keys, {"station_pt", "point", "center_activate"})) return true;
  if (params_.is_center_activated) {
    watch_.is_center_due = true;
  } else if (params_.station) {
    watch_ = {.station = params_.station, .swings_until = {}, .distances = {}};
  }
  return true;
}

void BHV_StationKeep::Start(const VehicleState& state) {
  watch_.distances.clear();
  watch_.rest = Rest::kHibernating;
  watch_.is_center_due = false;
  if (params_.is_center_activated) {
    watch_.station = state.place();
    watch_.swings_until = state.now + params_.swing_time;
  } else if (!watch_.station) {
    watch_.station = params_.station;
  }
}

double BHV_StationKeep::outer_radius() const {
  return std::max(params_.outer_radius.value(), params_.inner_radius.value());
}

double BHV_StationKeep::Speed(double distance) const {
  const double inner = params_.inner_radius.value(), outer = outer_radius();
  if (distance <= inner) return 0.0;
  if (distance >= outer) {
    return std::max(params_.transit_speed.value(), params_.outer_speed.value());
  }
  return params_.outer_speed.value() * (distance - inner) / (outer - inner);
}

std::optional<double> BHV_StationKeep::Drift() const {
  if (watch_.distances.empty()) return std::nullopt;
  const auto& [first, before] = watch_.distances.front();
  const auto& [last, now] = watch_.distances.back();
  const Seconds elapsed = last - first;
  return elapsed > kEnough ? std::optional((now - before) / elapsed.value()) : std::nullopt;
}

bool BHV_StationKeep::MayRest(double distance, Seconds now) {
  if (!params_.hibernation_radius) return false;
  watch_.distances.emplace_back(now, distance);
  while (now - watch_.distances.front().first > kRemembered)
    watch_.distances.pop_front();
  const double far = params_.hibernation_radius->value();
  const Rest before = watch_.rest;
  const std::optional<double> drift = Drift();
  const bool comes_no_nearer =
      before == Rest::kClosing && distance <= far && drift && *drift >= kNoNearer;
  if (before == Rest::kHibernating) {
    if (distance > far) watch_.rest = Rest::kSeeking;
  } else if (distance <= params_.inner_radius.value() || comes_no_nearer) {
    watch_.rest = Rest::kHibernating;
  } else if (before == Rest::kSeeking && distance <= far && drift && *drift <= 0.0) {
    watch_.rest = Rest::kClosing;
  }
  if (watch_.rest != before) watch_.distances.clear();
  return watch_.rest == Rest::kHibernating;
}

MotionBid BHV_StationKeep::Move(const VehicleState& state) {
  MotionBid bid;
  if (watch_.is_center_due) {
    watch_ = {.station = state.place(), .swings_until = {}, .distances = {}};
  }
  if (!watch_.station) {
    bid.warning = BehaviorWarning{kNoStation, "neither station_pt nor center_activate"};
    return bid;
  }
  const MapPoint at = state.place();
  const bool swings = watch_.swings_until && state.now < *watch_.swings_until;
  if (swings) watch_.station = at;
  const double distance = DistanceBetween(at, *watch_.station);
  const bool rests = MayRest(distance, state.now);
  ActList acts;
  acts.Post("DIST_TO_STATION", distance);
  acts.Post("PSKEEP_MODE", std::string(!params_.hibernation_radius ? "DISABLED"
                                       : rests                     ? "HIBERNATING"
                                                                   : "SEEKING_STATION"));
  Draw(state, true, acts);
  constexpr double kSpeedSkirt = 0.4;  // [m/s]
  const double course = swings || distance == 0.0 ? state.nav.yaw : BearingTo(at, *watch_.station);
  bid.course = Peak{.summit = course,
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = kCoupledShare};
  bid.speed = Peak{.summit = rests ? 0.0 : Speed(distance),
                   .flat_half_width = 0.0,
                   .base_half_width = kSpeedSkirt,
                   .share = kCoupledShare};
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_StationKeep::Stop(const VehicleState& state) {
  ActList acts;
  if (watch_.station) Draw(state, false, acts);
  return acts.Take();
}

void BHV_StationKeep::Draw(const VehicleState& state, bool is_active, ActList& acts) const {
  const std::string label = std::string(state.ownship) + ":station-keep-";
  const CircleDrawing circles{.center = *watch_.station, .hints = params_.hints};
  const double inner = params_.inner_radius.value(), outer = outer_radius();
  acts.Draw(circles.Draw(label + "out", outer, is_active));
  if (inner < outer || !is_active) acts.Draw(circles.Draw(label + "in", inner, is_active));
  const double far = params_.hibernation_radius.value_or(Meters(0.0)).value();
  if (far > outer) acts.Draw(circles.Draw(label + "hiber", far, is_active));
}

LIMPET_REGISTER_BEHAVIOR(BHV_StationKeep);

}  // namespace limpet
