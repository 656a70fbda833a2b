// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantDepth.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {

void BHV_ConstantDepth::Params::Describe(ParamCollector& visit) {
  visit("depth", depth, "Depth to keep; below 0: the surface",
        InRange(Meters(-6000.0), Meters(6000.0)));
  visit("peakwidth", peakwidth, "Depths this near are nearly as good: less summitdelta at its end",
        AtLeast(Meters(0.0)));
  visit.Clipped();
  visit("basewidth", basewidth, "Beyond that, preference falls to nothing over this depth",
        AtLeast(Meters(0.0)));
  visit.Clipped();
  DescribeSummitDelta(visit, summit_delta);
  DescribeVariable(visit, "depth_mismatch_var", mismatch_variable,
                   "Where the difference from this depth goes [m]");
}

MotionBid BHV_ConstantDepth::Move(const VehicleState& state) {
  const double flat = params_.peakwidth.value();
  const double depth = std::max(params_.depth.value(), 0.0);
  ActList acts;
  TellMismatch(state, acts);
  MotionBid bid;
  bid.depth = Peak{
      .summit = depth,
      .flat_half_width = flat,
      .base_half_width = BaseBeyond({.flat_half_width = flat, .skirt = params_.basewidth.value()}),
      .edge_value = EdgeValue(params_.summit_delta)};
  bid.acts = acts.Take();
  return bid;
}

/// Also while it is idle: a mode may hang on it.
void BHV_ConstantDepth::TellMismatch(const VehicleState& state, ActList& acts) const {
  acts.Post(params_.mismatch_variable,
            std::abs(state.nav.down - std::max(params_.depth.value(), 0.0)));
}

std::vector<BehaviorAct> BHV_ConstantDepth::Idle(const VehicleState& state) {
  ActList acts;
  TellMismatch(state, acts);
  return acts.Take();
}

LIMPET_REGISTER_BEHAVIOR(BHV_ConstantDepth);

}  // namespace limpet
