// SPDX-License-Identifier: MIT
#include "apps/pSurvey/transit.hpp"

#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/transit_path.hpp"

namespace limpet {
namespace {

/// Nearer by less is no progress: a vehicle that a current holds sways [m].
constexpr double kProgressStepM = 1.0;
/// Turn radius of a vehicle like any: it is asked how far it has come, not how it turns.
constexpr Meters kTurn(3.0);

}  // namespace

double Transit::WayLeft(const PlanePoint& here) const {
  PlanePoint at = here;
  double way = 0.0;
  for (const PlanePoint& place : RestOfWay(*places_, here, kTurn)) {
    way += (place - at).norm();
    at = place;
  }
  return way;
}

bool Transit::Track(const NavState& nav, const Region& region) {
  const Pose2 pose{.north = nav.north, .east = nav.east, .yaw = nav.yaw};
  const PlanePoint here(nav.north, nav.east);
  if (!places_) places_ = TransitPlaces(here, region, kTurn);
  const double outside = region.Outside(pose);
  const bool goes_round = !places_->empty() && IsInTransit(region, pose);
  const double to_go = goes_round ? WayLeft(here) : outside;
  if (outside > 0.0 && to_go > to_go_m_ - kProgressStepM) {
    return false;
  }
  to_go_m_ = to_go;
  return true;
}

}  // namespace limpet
