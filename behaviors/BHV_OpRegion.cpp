// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegion.hpp"

#include <cmath>
#include <numbers>

#include "limpet/helm/registry.hpp"

namespace limpet {

MotionBid BHV_OpRegion::Move(const VehicleState& state) {
  if (!state.area) {
    return {};
  }
  const SurveyArea& area = *state.area;
  const Pose2 here{.north = state.nav.north, .east = state.nav.east, .yaw = state.nav.yaw};
  const double outside = Region(area).Outside(here);
  if (outside <= params_.tolerance.value()) {
    return {};
  }
  // The path in force leads back if it can; this only warns, and pulls when there is no path.
  MotionBid bid;
  bid.warning = BehaviorWarning{"OUTSIDE_REGION", "the vehicle is outside its operating region"};
  if (!state.guidance) {
    const double to_north = 0.5 * (area.north_min + area.north_max) - here.north;
    const double to_east = 0.5 * (area.east_min + area.east_max) - here.east;
    bid.course = Peak{.summit = std::atan2(to_east, to_north),
                      .flat_half_width = 0.0,
                      .base_half_width = std::numbers::pi};
  }
  return bid;
}

std::optional<Bid> BHV_OpRegion::Value(const Prospect& prospect, const Situation& now) const {
  Bid bid;
  const bool starts_inside = now.region->Outside(now.pose) <= 0.0;
  const bool leads_in = now.region->Outside(prospect.path().end()) <= 0.0;
  if (starts_inside && !now.region->Contains(prospect.path()) &&
      prospect.option->source != "home") {
    bid.veto = "leaves the operating region";
  } else if (!starts_inside && !leads_in && prospect.option->source != "home") {
    bid.veto = "does not lead back into the operating region";
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_OpRegion);

}  // namespace limpet
