// SPDX-License-Identifier: MIT
#include "behaviors/BHV_FullStop.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

Shape BeginShape(std::string_view vehicle, const MapPoint& at, const VisualHints& hints,
                 bool is_active) {
  return {.label = "fstop_" + std::string(vehicle),
          .form = PointShape{at},
          .style = {.label_color = hints.Text("label_color", "off"),
                    .vertex_color = hints.Text("vertex_color", "pink"),
                    .vertex_size = hints.Number("vertex_size", 10.0)},
          .is_active = is_active};
}

}  // namespace

void BHV_FullStop::Params::Describe(ParamCollector& visit) {
  visit("stop_thresh", stop_threshold, "Slower than this it stands",
        InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit("delay_complete", complete_delay, "Complete so long after it has come to stand",
        InRange(Seconds(0.0), Seconds(1e6)));
  visit("mark_duration", mark_duration, "How long after its begin unmark_flag comes",
        InRange(Seconds(0.0), Seconds(1e6)));
  DescribeFlags(visit, "mark_flag", mark_flags, "Posted as it begins, unless mark_duration is 0");
  DescribeFlags(visit, "unmark_flag", unmark_flags, "Posted after mark_duration");
  DescribeHints(visit, hints);
}

bool BHV_FullStop::TakeOver(const Behavior& former, const std::vector<std::string>&) {
  braking_ = dynamic_cast<const BHV_FullStop&>(former).braking_;
  return true;
}

void BHV_FullStop::Start(const VehicleState& state) {
  braking_ = {.began = state.now,
              .from = state.place(),
              .last = state.place(),
              .heading = state.nav.yaw,
              .stopped = {}};
}

void BHV_FullStop::RaiseMarks(const VehicleState& state, ActList& acts) {
  const bool is_marked = state.now - braking_.began < params_.mark_duration;
  if (is_marked && !braking_.is_marked) {
    braking_.is_marked = true;
    acts.Raise(params_.mark_flags, *this, state);
  } else if (!is_marked && !braking_.is_unmarked) {
    braking_.is_unmarked = true;
    acts.Raise(params_.unmark_flags, *this, state);
  }
}

/// Slow, or on its way back: thrust astern may have turned a slow vehicle round between two looks.
bool BHV_FullStop::IsStopped(const VehicleState& state) {
  constexpr double kBack = 0.1;  // [m] less may be the navigation's noise
  const double distance = DistanceBetween(state.place(), braking_.from);
  braking_.farthest = std::max(braking_.farthest, distance);
  return state.speed() < params_.stop_threshold.value() || distance < braking_.farthest - kBack;
}

MotionBid BHV_FullStop::Move(const VehicleState& state) {
  MotionBid bid;
  if (braking_.is_over) return bid;
  braking_.way += DistanceBetween(braking_.last, state.place());
  braking_.last = state.place();
  ActList acts;
  RaiseMarks(state, acts);
  if (!braking_.stopped && IsStopped(state)) braking_.stopped = state.now;
  bid.acts = acts.Take();
  std::ranges::move(Draw(state, true), std::back_inserter(bid.acts));
  if (braking_.stopped && state.now - *braking_.stopped >= params_.complete_delay) {
    braking_.is_over = true;
    bid.acts.emplace_back(Completion{});
    return bid;
  }
  constexpr double kSpeedSkirt = 0.1;  // [m/s] nothing faster will do
  bid.course = Peak{.summit = braking_.heading,
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = kCoupledShare};
  bid.speed = Peak{.summit = 0.0,
                   .flat_half_width = 0.0,
                   .base_half_width = kSpeedSkirt,
                   .share = kCoupledShare};
  return bid;
}

std::vector<BehaviorAct> BHV_FullStop::Stop(const VehicleState& state) {
  return Draw(state, false);
}

std::vector<BehaviorAct> BHV_FullStop::Draw(const VehicleState& state, bool is_active) const {
  ActList acts;
  acts.Draw(std::vector{
      DrawnTextOf(BeginShape(state.ownship, braking_.from, params_.hints, is_active), "bpt1")});
  return acts.Take();
}

std::optional<std::string> BHV_FullStop::Macro(std::string_view name,
                                               const VehicleState& state) const {
  if (name == "STOP_DIST") return MacroNumber(braking_.way);
  if (name == "STOP_TIME") return MacroNumber((state.now - braking_.began).value());
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_FullStop);

}  // namespace limpet
