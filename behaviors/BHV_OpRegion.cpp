// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/transit_path.hpp"

namespace limpet {
namespace {

constexpr const char* kHome = "home";  ///< source of the options that may end anywhere

bool LeadsIn(const Option& option, const Region& region) {
  return option.source != kHome && region.Outside(option.path.end()) <= 0.0;
}

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
  const bool is_going_home = state.guidance && state.guidance->purpose == kHome;
  if (!has_entered_ || is_going_home || outside <= params_.tolerance.value()) {
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

void BHV_OpRegion::Offer(const Situation& now, std::vector<Option>& options) const {
  const Region& region = *now.region;
  const bool is_led_in = std::ranges::any_of(
      options, [&region](const Option& option) { return LeadsIn(option, region); });
  if (region.Outside(now.pose) <= 0.0 || is_led_in) {
    return;
  }
  if (std::optional<Option> transit = TransitPath(now.pose, region, now.turn_radius)) {
    options.push_back(*std::move(transit));
  }
}

std::optional<Bid> BHV_OpRegion::Value(const Prospect& prospect, const Situation& now) const {
  Bid bid;
  const bool starts_inside = now.region->Outside(now.pose) <= 0.0;
  if (prospect.option->source == kHome) {
    return bid;
  }
  if (starts_inside && !now.region->Contains(prospect.path())) {
    bid.veto = "leaves the operating region";
  } else if (!starts_inside && !LeadsIn(*prospect.option, *now.region)) {
    bid.veto = "does not lead into the operating region";
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_OpRegion);

}  // namespace limpet
