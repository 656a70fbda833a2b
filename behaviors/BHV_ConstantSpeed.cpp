// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantSpeed.hpp"

#include <cmath>

#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {

void BHV_ConstantSpeed::Params::Describe(ParamCollector& visit) {
  visit("speed", speed, "Speed to keep", InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit.Clipped();
  visit("peakwidth", peakwidth, "Speeds this near are nearly as good: less summitdelta at its end",
        AtLeast(MetersPerSecond(0.0)));
  visit.Clipped();
  visit("basewidth", basewidth, "Beyond that, preference falls to nothing over this speed",
        AtLeast(MetersPerSecond(0.0)));
  visit.Clipped();
  DescribeSummitDelta(visit, summit_delta);
  DescribeVariable(visit, "speed_mismatch_var", mismatch_variable,
                   "Where the difference from this speed goes [m/s]");
}

MotionBid BHV_ConstantSpeed::Move(const VehicleState& state) {
  const double flat = params_.peakwidth.value();
  ActList acts;
  TellMismatch(state, acts);
  MotionBid bid;
  bid.speed = Peak{
      .summit = params_.speed.value(),
      .flat_half_width = flat,
      .base_half_width = BaseBeyond({.flat_half_width = flat, .skirt = params_.basewidth.value()}),
      .edge_value = EdgeValue(params_.summit_delta)};
  bid.acts = acts.Take();
  return bid;
}

/// Also while it is idle: a mode may hang on it.
void BHV_ConstantSpeed::TellMismatch(const VehicleState& state, ActList& acts) const {
  acts.Post(params_.mismatch_variable, std::abs(state.speed() - params_.speed.value()));
}

std::vector<BehaviorAct> BHV_ConstantSpeed::Idle(const VehicleState& state) {
  ActList acts;
  TellMismatch(state, acts);
  return acts.Take();
}

LIMPET_REGISTER_BEHAVIOR(BHV_ConstantSpeed);

}  // namespace limpet
