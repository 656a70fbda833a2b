// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegion.hpp"

#include <cmath>
#include <numbers>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/transit_path.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {
namespace {

const WarningId kOutsideRegion = DeclareWarning(
    "OUTSIDE_REGION",
    {.severity = Severity::kAlarm,
     .raised_by = {"BHV_OpRegion"},
     .meaning = "The vehicle has left its operating region by more than tolerance_m.",
     .action =
         "Watch it come back; if it does not, stop it with MOOS_MANUAL_OVERRIDE and it floats "
         "up.",
     .clears = "Once it is inside again, or on its way home."});

}  // namespace

void BHV_OpRegion::Start(const VehicleState& state) {
  static_cast<void>(state);
  has_entered_ = false;
}

MotionBid BHV_OpRegion::Move(const VehicleState& state) {
  if (!state.area) {
    return {};
  }
  const SurveyArea& area = *state.area;
  const Pose2 here{.north = state.nav.north, .east = state.nav.east, .yaw = state.nav.yaw};
  const double outside = Region(area).Outside(here);
  has_entered_ = has_entered_ || outside <= 0.0;
  const bool is_going_home = state.guidance && state.guidance->purpose == kHomeSource;
  if (!has_entered_ || is_going_home || outside <= params_.tolerance.value()) {
    return {};
  }
  // The path in force leads back if it can; this only warns, and pulls when there is no path.
  MotionBid bid;
  bid.warning = BehaviorWarning{kOutsideRegion, "the vehicle is outside its operating region"};
  if (!state.guidance) {
    const double to_north = 0.5 * (area.north_min + area.north_max) - here.north;
    const double to_east = 0.5 * (area.east_min + area.east_max) - here.east;
    bid.course = Peak{.summit = std::atan2(to_east, to_north),
                      .flat_half_width = 0.0,
                      .base_half_width = std::numbers::pi};
  }
  return bid;
}

void BHV_OpRegion::Shape(const Situation&, double, SearchGoals& goals) const {
  goals.leads_into_region = true;
}

std::optional<Bid> BHV_OpRegion::Value(const Prospect& prospect, const Situation& now) const {
  Bid bid;
  const bool starts_inside = now.region->Outside(now.pose) <= 0.0;
  if (MayEndAnywhere(*prospect.option)) {
    return bid;
  }
  if (starts_inside && !now.region->Contains(prospect.path())) {
    bid.veto = "leaves the operating region";
  } else if (!starts_inside && !LeadsInto(*now.region, *prospect.option)) {
    bid.veto = "does not lead into the operating region";
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_OpRegion);

}  // namespace limpet
