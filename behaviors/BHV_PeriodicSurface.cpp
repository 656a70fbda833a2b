// SPDX-License-Identifier: MIT
#include "behaviors/BHV_PeriodicSurface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

/// `VARIABLE, seconds, seconds`.
std::optional<BHV_PeriodicSurface::PutOff> ParsePutOff(std::string_view text) {
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 3) return std::nullopt;
  const std::string variable(Trim(parts[0]));
  const auto each = ParseNumber(parts[1]), most = ParseNumber(parts[2]);
  const bool is_name = !variable.empty() && variable.find_first_of(" \t") == std::string::npos;
  if (!is_name || !each || !most || *each <= 0.0 || *most < *each) return std::nullopt;
  return BHV_PeriodicSurface::PutOff{
      .variable = variable, .each = Seconds(*each), .most = Seconds(*most)};
}

}  // namespace

void BHV_PeriodicSurface::Params::Describe(ParamCollector& visit) {
  visit("period", period, "Time between ascents", InRange(Seconds(1e-3), Seconds(1e6)));
  DescribeVariable(visit, "mark_variable", mark_variable,
                   "A new value of it ends the stay at the surface, or puts the ascent off");
  DescribeVariable(visit, "pending_status_var", pending_variable,
                   "Where the seconds until the next ascent go");
  visit.Also({"pending_status_variable"});
  DescribeVariable(visit, "atsurface_status_var", surface_variable,
                   "Where the seconds at the surface go");
  visit.Also({"atsurface_status_variable"});
  visit.Parsed("ascent_speed", "a number in mps, or current", "Speed as the ascent begins",
               "current", [this](std::string_view text) {
                 const auto speed = ParseNumber(text);
                 if (text != "current" && (!speed || *speed < 0.0)) return false;
                 ascent_speed = speed ? std::optional(MetersPerSecond(*speed)) : std::nullopt;
                 return true;
               });
  visit.Also({"speed_to_surface"});
  visit.Parsed("ascent_grade", "linear, quadratic, quasi, fullspeed; in any letters",
               "How the speed falls on the way up", "linear", [this](std::string_view text) {
                 constexpr std::array kGrades{"linear", "quadratic", "quasi", "fullspeed"};
                 const auto grade = std::ranges::find_if(kGrades, [text](const char* known) {
                   return EqualsIgnoringCase(known, text);
                 });
                 if (grade == kGrades.end()) return false;
                 ascent_grade = *grade;
                 return true;
               });
  visit("zero_speed_depth", zero_speed_depth, "From this depth up it is at the surface",
        InRange(Meters(0.0), Meters(6000.0)));
  visit("max_time_at_surface", longest_stay, "It dives again after so long without a mark",
        InRange(Seconds(0.0), Seconds(1e6)));
  visit.Parsed("acomms_mark_variable", "VARIABLE, seconds above 0, as many seconds or more",
               "Each new text of it puts the ascent off by so much, up to so much in a period", "",
               [this](std::string_view text) {
                 put_off = ParsePutOff(text);
                 return put_off || text.empty();
               });
}

std::vector<std::string> BHV_PeriodicSurface::Variables() const {
  std::vector<std::string> names{params_.mark_variable};
  if (params_.put_off) names.push_back(params_.put_off->variable);
  return names;
}

bool BHV_PeriodicSurface::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  dive_ = dynamic_cast<const BHV_PeriodicSurface&>(former).dive_;
  if (HasKey(keys, {"acomms_mark_variable"})) dive_.put_off = Seconds(0.0);
  return true;
}

Seconds BHV_PeriodicSurface::Pending(Seconds now) const {
  return params_.period - (now - dive_.marked.value_or(now)) + dive_.put_off;
}

void BHV_PeriodicSurface::HearPutOff(const VehicleState& state) {
  if (!params_.put_off) return;
  const Stamped<limpet::Value>* heard = state.Heard(params_.put_off->variable);
  const auto* text = heard != nullptr ? std::get_if<std::string>(&heard->value) : nullptr;
  if (text == nullptr || *text == dive_.put_off_text) return;
  dive_.put_off_text = *text;
  dive_.put_off = std::min(dive_.put_off + params_.put_off->each, params_.put_off->most);
}

bool BHV_PeriodicSurface::IsMarked(const VehicleState& state) {
  const Stamped<limpet::Value>* heard = state.Heard(params_.mark_variable);
  const bool is_new = heard != nullptr && dive_.mark != heard->value;
  if (is_new) dive_.mark = heard->value;
  return is_new || !dive_.marked;  // the first period begins with the first iteration
}

std::vector<BehaviorAct> BHV_PeriodicSurface::Idle(const VehicleState& state) {
  if (!dive_.marked && state.nav.down >= params_.zero_speed_depth.value()) {
    dive_.marked = state.now;
  }
  ActList acts;
  acts.Post(params_.pending_variable, std::round(Pending(state.now).value()));
  return acts.Take();
}

double BHV_PeriodicSurface::AscentSpeed(double depth) const {
  const double top = params_.zero_speed_depth.value();
  if (depth <= top || dive_.begin_depth <= top) return 0.0;
  const double share = std::min(1.0, (depth - top) / (dive_.begin_depth - top));
  const std::string& grade = params_.ascent_grade;
  const double power = grade == "quadratic"   ? 2.0
                       : grade == "quasi"     ? 1.5
                       : grade == "fullspeed" ? 0.0
                                              : 1.0;
  return dive_.begin_speed * std::pow(share, power);
}

void BHV_PeriodicSurface::Ascend(const VehicleState& state, ActList& acts) {
  if (dive_.phase == Phase::kWaiting) {
    dive_.phase = Phase::kAscending;
    dive_.begin_depth = state.nav.down;
    dive_.begin_speed = params_.ascent_speed.value_or(MetersPerSecond(state.speed())).value();
    acts.Post("PERIODIC_ASCEND", std::string("true"));
  }
  if (dive_.phase == Phase::kAscending && state.nav.down <= params_.zero_speed_depth.value()) {
    dive_.phase = Phase::kAtSurface;
    dive_.surfaced = state.now;
    acts.Post("PERIODIC_ASCEND", std::string("false"));
  }
}

MotionBid BHV_PeriodicSurface::Move(const VehicleState& state) {
  ActList acts;
  MotionBid bid;
  acts.Post(params_.pending_variable, std::round(Pending(state.now).value()));
  const bool is_marked = IsMarked(state);
  if (is_marked) {
    dive_.marked = state.now;
    dive_.put_off = Seconds(0.0);
  } else {
    HearPutOff(state);
  }
  if (is_marked || Pending(state.now) > Seconds(0.0)) {
    if (dive_.phase == Phase::kAscending) acts.Post("PERIODIC_ASCEND", std::string("false"));
    dive_.phase = Phase::kWaiting;
    acts.Post(params_.surface_variable, 0.0);
    bid.acts = acts.Take();
    return bid;
  }
  Ascend(state, acts);
  const Seconds stay = dive_.phase == Phase::kAtSurface ? state.now - dive_.surfaced : Seconds(0.0);
  acts.Post(params_.surface_variable, std::round(stay.value()));
  if (dive_.phase == Phase::kAtSurface && stay >= params_.longest_stay) {
    dive_.phase = Phase::kWaiting;
    dive_.marked = state.now;
    acts.Post("PSF_AT_SURFACE_TIMEOUT", fmt::format("Timestamp={:.2f}", state.now.value()));
  } else {
    constexpr double kSpeedSkirt = 0.5, kStopSkirt = 0.1;  // [m/s] nothing faster than a stop does
    constexpr double kDepthSkirt = 0.1;                    // [m] nothing deeper will do
    const double speed = AscentSpeed(state.nav.down);
    bid.speed = Peak{.summit = speed,
                     .flat_half_width = 0.0,
                     .base_half_width = speed > 0.0 ? kSpeedSkirt : kStopSkirt,
                     .share = kCoupledShare};
    bid.depth = Peak{.summit = 0.0,
                     .flat_half_width = 0.0,
                     .base_half_width = kDepthSkirt,
                     .share = kCoupledShare};
  }
  bid.acts = acts.Take();
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_PeriodicSurface);

}  // namespace limpet
