// SPDX-License-Identifier: MIT
#include "behaviors/BHV_MaxDepth.hpp"

#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {

void BHV_MaxDepth::Params::Describe(ParamCollector& visit) {
  visit("max_depth", max_depth, "Depths down to this are as good",
        InRange(Meters(0.0), Meters(6000.0)));
  visit.Clipped();
  visit("basewidth", basewidth, "Preference falls to nothing over this depth below it",
        AtLeast(Meters(0.0)));
  visit.Also({"tolerance"});
  visit.Clipped();
  DescribeVariable(visit, "depth_slack_var", slack_variable,
                   "Where the depth left below the vehicle goes [m]");
}

MotionBid BHV_MaxDepth::Move(const VehicleState& state) {
  const double deepest = params_.max_depth.value();
  ActList acts;
  acts.Post(params_.slack_variable, deepest - state.nav.down);
  MotionBid bid;
  bid.depth = Peak{.summit = 0.5 * deepest,
                   .flat_half_width = 0.5 * deepest,
                   .base_half_width = BaseBeyond(
                       {.flat_half_width = 0.5 * deepest, .skirt = params_.basewidth.value()})};
  bid.acts = acts.Take();
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_MaxDepth);

}  // namespace limpet
