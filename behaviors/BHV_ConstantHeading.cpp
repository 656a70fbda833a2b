// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantHeading.hpp"

#include <cmath>

#include "limpet/core/frames.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

/// [deg] More than half a turn is never reached, and makes slopes that are as shallow as missions
/// want them.
constexpr double kWidest = 360.0;

}  // namespace

void BHV_ConstantHeading::Params::Describe(ParamCollector& visit) {
  visit("heading", heading, "Heading to keep, clockwise from north; 370 is 10",
        InRange(Radians::FromTextUnit(-36000.0), Radians::FromTextUnit(36000.0)));
  visit("peakwidth", peakwidth,
        "Headings this near are nearly as good: less summitdelta at its end",
        InRange(Radians(0.0), Radians::FromTextUnit(kWidest)));
  visit.Clipped();
  visit("basewidth", basewidth, "Beyond that, preference falls to nothing over this angle",
        InRange(Radians(0.0), Radians::FromTextUnit(kWidest)));
  visit.Clipped();
  DescribeSummitDelta(visit, summit_delta);
  visit("complete_thresh", complete_threshold, "Complete when this near; below 0: never",
        InRange(Radians::FromTextUnit(-1.0), Radians::FromTextUnit(180.0)));
  visit.Clipped();
  DescribeVariable(visit, "heading_mismatch_var", mismatch_variable,
                   "Where the angle off this heading goes [deg]");
}

MotionBid BHV_ConstantHeading::Move(const VehicleState& state) {
  ActList acts;
  TellMismatch(state, acts);
  MotionBid bid;
  if (Off(state) < params_.complete_threshold.value()) {
    acts.Complete();
  } else {
    const double flat = params_.peakwidth.value();
    bid.course = Peak{.summit = WrapAngle(params_.heading.value()),
                      .flat_half_width = flat,
                      .base_half_width =
                          BaseBeyond({.flat_half_width = flat, .skirt = params_.basewidth.value()}),
                      .edge_value = EdgeValue(params_.summit_delta)};
  }
  bid.acts = acts.Take();
  return bid;
}

double BHV_ConstantHeading::Off(const VehicleState& state) const {
  return std::abs(WrapAngle(state.nav.yaw - params_.heading.value()));
}

/// Also while it is idle: a mode may hang on it.
void BHV_ConstantHeading::TellMismatch(const VehicleState& state, ActList& acts) const {
  acts.Post(params_.mismatch_variable, DegreesFromRadians(Off(state)));
}

std::vector<BehaviorAct> BHV_ConstantHeading::Idle(const VehicleState& state) {
  ActList acts;
  TellMismatch(state, acts);
  return acts.Take();
}

LIMPET_REGISTER_BEHAVIOR(BHV_ConstantHeading);

}  // namespace limpet
