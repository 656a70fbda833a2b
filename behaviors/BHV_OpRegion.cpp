// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/frames.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/planning/fence_allowance.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/place_inside.hpp"
#include "limpet/planning/transit_path.hpp"
#include "limpet/topics/warning.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

const WarningId kOutsideRegion = DeclareWarning(
    "OUTSIDE_REGION",
    {.severity = Severity::kAlarm,
     .raised_by = {"BHV_OpRegion"},
     .meaning = "The vehicle has left its operating region, or is in a keep-out zone, by more than "
                "tolerance_m.",
     .action =
         "Watch it come back; if it does not, stop it with MOOS_MANUAL_OVERRIDE and it floats "
         "up.",
     .clears = "Once it is inside again, or on its way home in no zone."});

const WarningId kRegionInDoubt = DeclareWarning(
    "REGION_IN_DOUBT",
    {.severity = Severity::kWarning,
     .raised_by = {"BHV_OpRegion"},
     .meaning = "The vehicle is nearer to the border of its operating region, or to a keep-out "
                "zone, than three sigmas of its place: it may be on the other side.",
     .action = "Give the region a wider margin, or let it come up for a fix (BHV_SurfaceFix).",
     .clears = "Half a metre farther from the border, or once its place is known better."});

}  // namespace

void BHV_OpRegion::Params::Describe(ParamCollector& visit) {
  visit("tolerance_m", tolerance, "Further outside than this raises the alarm and turns back",
        InRange(Meters(0.0), Meters(20.0)));
  visit("lead_speed_mps", lead_speed,
        "Where no path is left, it turns the vehicle on the spot and leads it farther inside as "
        "fast as this",
        InRange(MetersPerSecond(0.01), MetersPerSecond(2.0)));
  limits.DescribeLimits(visit, "polygon");
  limits.tells_borders = true;
  visit("soft_poly_breach", limits.is_soft,
        "Outside the polygon the vehicle is the operator's (MOOS_MANUAL_OVERRIDE), not stopped");
  DescribeVariable(visit, "time_remaining_var", limits.time_variable,
                   "Seconds left of max_time; -1 without");
  DescribeVariable(visit, "opregion_poly_var", limits.polygon_variable, "Gets the polygon");
}

bool BHV_OpRegion::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_OpRegion&>(former);
  area_ = old.area_;
  region_ = old.region_;
  has_entered_ = old.has_entered_;
  is_in_doubt_ = old.is_in_doubt_;
  return limits_.TakeOver(old.limits_, keys);
}

std::vector<BehaviorAct> BHV_OpRegion::Stop(const VehicleState& state) {
  return limits_.Stop(state);
}

void BHV_OpRegion::Start(const VehicleState& state) {
  static_cast<void>(state);
  has_entered_ = false;
  without_path_since_.reset();
  lead_to_.reset();
}

bool BHV_OpRegion::IsInDoubt(const VehicleState& state, double clearance) {
  constexpr double kClear = 0.5;  // [m] beyond them it is sure again
  const double sigmas = FenceAllowance::kSigmas * std::max(state.nav.sd_north, state.nav.sd_east);
  // Nobody may have said how sure the place is.
  is_in_doubt_ = sigmas > 0.0 && clearance < sigmas + (is_in_doubt_ ? kClear : 0.0);
  return is_in_doubt_;
}

MotionBid BHV_OpRegion::Move(const VehicleState& state) {
  MotionBid bid = limits_.Move(state);
  if (state.area) MoveInArea(state, bid);
  return bid;
}

void BHV_OpRegion::MoveInArea(const VehicleState& state, MotionBid& bid) {
  if (area_ != state.area) {
    area_ = state.area;
    region_.emplace(*area_);
    lead_to_.reset();
  }
  const Pose2 here{.north = state.nav.north, .east = state.nav.east, .yaw = state.nav.yaw};
  has_entered_ = has_entered_ || region_->Outside(here) <= 0.0;
  const bool is_going_home = state.guidance && state.guidance->purpose == kHomeSource;
  // The ways in and home may be outside the region, and are in no zone.
  const bool is_within = has_entered_ && !is_going_home;
  WarnOfBorders(state, is_within, bid);
  if (is_within) LeadInside(state, region_->Outside(here), bid);
}

void BHV_OpRegion::WarnOfBorders(const VehicleState& state, bool is_within, MotionBid& bid) {
  const PlanePoint place(state.nav.north, state.nav.east);
  const double clearance = is_within ? region_->Clearance(place) : region_->ZoneClearance(place);
  if (-clearance > params_.tolerance.value()) {
    bid.warning =
        BehaviorWarning{kOutsideRegion, is_within ? "the vehicle is outside its operating region"
                                                  : "the vehicle is in a keep-out zone"};
  } else if (IsInDoubt(state, clearance)) {
    bid.warning = BehaviorWarning{
        kRegionInDoubt,
        is_within ? "three sigmas of the vehicle's place reach over a border of its region"
                  : "three sigmas of the vehicle's place reach into a keep-out zone"};
  }
}

void BHV_OpRegion::LeadInside(const VehicleState& state, double outside, MotionBid& bid) {
  constexpr Seconds kPatience(2.0);  // a decision may take as long
  constexpr double kThere = 1.0;     // [m]
  if (state.guidance) {
    without_path_since_.reset();
    lead_to_.reset();
    return;
  }
  if (!without_path_since_) without_path_since_ = state.now;
  if (outside <= params_.tolerance.value() && state.now - *without_path_since_ < kPatience) return;
  const PlanePoint here(state.nav.north, state.nav.east);
  if (!lead_to_) lead_to_ = PlaceInside(*region_, here).value_or(here);
  const PlanePoint way = *lead_to_ - here;
  if (way.norm() < kThere) return;
  const double course = std::atan2(way.y(), way.x()), speed = params_.lead_speed.value();
  bid.course = Peak{.summit = course, .flat_half_width = 0.0, .base_half_width = std::numbers::pi};
  bid.speed = Peak{.summit = speed * std::max(0.0, std::cos(WrapAngle(course - state.nav.yaw))),
                   .flat_half_width = 0.0,
                   .base_half_width = speed};
}

void BHV_OpRegion::Shape(const Situation&, double, SearchGoals& goals) const {
  goals.leads_into_region = true;
}

std::optional<Bid> BHV_OpRegion::Value(const Prospect& prospect, const Situation& now) const {
  Bid bid;
  const bool starts_inside = now.region->Outside(now.pose) <= 0.0;
  const bool may_end_anywhere = MayEndAnywhere(*prospect.option);
  // Whoever is in a zone has to get out of it first, and may cross more of it on the way.
  const bool heeds_zones = (starts_inside || !may_end_anywhere) &&
                           !now.region->IsInZone({now.pose.north, now.pose.east});
  if (heeds_zones && now.region->EntersZone(prospect.path())) {
    bid.veto = "enters a keep-out zone";
    return bid;
  }
  if (may_end_anywhere) {
    return bid;
  }
  if (starts_inside && !now.region->Contains(prospect.path())) {
    bid.veto = "leaves the operating region";
  } else if (!starts_inside && !LeadsInto(*now.region, *prospect.option)) {
    bid.veto = "does not lead into the operating region";
  } else if (!has_entered_ && IsInTransit(*now.region, now.pose) &&
             prospect.option->source != kTransitSource) {
    bid.veto = "is not the mission's transit";
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_OpRegion);

}  // namespace limpet
