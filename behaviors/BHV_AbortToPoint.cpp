// SPDX-License-Identifier: MIT
#include "behaviors/BHV_AbortToPoint.hpp"

#include <algorithm>
#include <numbers>

#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {

void BHV_AbortToPoint::Params::Describe(ParamCollector& visit) {
  visit.Parsed("point", "x,y",
               "Where: x east, y north of the datum [m]; until it is known, the vehicle is stopped",
               "", [this](std::string_view text) {
                 point = ParsePoint(text);
                 return text.empty() || point.has_value();
               });
  visit.NeededUnless("updates");
  visit.Required("speed", speed, "Speed on the way",
                 InRange(MetersPerSecond(0.01), MetersPerSecond(100.0)));
  visit("radius", radius, "This near it has arrived", InRange(Meters(0.1), Meters(1e5)));
  visit("nm_radius", slip_radius, "Arrived, too, when the distance grows again within this",
        InRange(Meters(0.1), Meters(1e5)));
  visit.WithoutEffect({"ipf-type", "ipf_type"});
}

bool BHV_AbortToPoint::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  if (HasKey(keys, {"point"})) return true;  // another way: it has not arrived
  const auto& old = dynamic_cast<const BHV_AbortToPoint&>(former);
  has_arrived_ = old.has_arrived_;
  nearest_ = old.nearest_;
  return true;
}

void BHV_AbortToPoint::Start(const VehicleState&) {
  has_arrived_ = false;
  nearest_.reset();
}

bool BHV_AbortToPoint::Arrives(double distance) {
  constexpr double kGrown = 1.0;  // [m] less may be the navigation's noise
  nearest_ = std::min(nearest_.value_or(distance), distance);
  const bool grows = distance > *nearest_ + kGrown;
  return distance <= params_.radius.value() || (grows && distance <= params_.slip_radius.value());
}

MotionBid BHV_AbortToPoint::Move(const VehicleState& state) {
  MotionBid bid;
  if (!params_.point) {
    bid.acts.emplace_back(Emergency{"it has no point to go to"});
    return bid;
  }
  const MapPoint at = state.place();
  const double distance = DistanceBetween(at, *params_.point);
  if (!has_arrived_ && Arrives(distance)) {
    has_arrived_ = true;
    bid.acts.emplace_back(Completion{});
  }
  const bool rests = has_arrived_ && distance <= params_.radius.value();
  constexpr double kSpeedSkirt = 2.6;  // [m/s]
  bid.course = Peak{.summit = BearingTo(at, *params_.point),
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = kCoupledShare};
  bid.speed = Peak{.summit = rests ? 0.0 : params_.speed.value(),
                   .flat_half_width = 0.0,
                   .base_half_width = kSpeedSkirt,
                   .share = kCoupledShare};
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_AbortToPoint);

}  // namespace limpet
