// SPDX-License-Identifier: MIT
#include "limpet/planning/fence_allowance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "limpet/core/require.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/planning/room.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

/// How far the region's border is from the area, where it is nearest [m]; 0 if it runs through it.
double MarginOf(const SurveyShape& shape) {
  if (!shape.region()) return shape.margin();
  double least = std::numeric_limits<double>::infinity();
  for (const PlanePoint& corner : shape.outline().corners()) {
    least = std::min(least, shape.region()->Depth(corner));
  }
  for (const PlanePoint& corner : shape.region()->corners()) {
    least = std::min(least, shape.OutsideArea(corner));
  }
  return std::max(0.0, least);
}

/// Cells from which a full turn fits, as far as they hang together.
double RoomOf(const FreeSpace& space, double radius) {
  return static_cast<double>(std::ranges::count(RoomToTurn(space, radius), std::uint8_t{1}));
}

}  // namespace

FenceAllowance::FenceAllowance(const SurveyArea& area, Meters tracking, Meters turn_radius)
    : tracking_(tracking), turn_radius_(turn_radius), region_(area, tracking) {
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  LIMPET_REQUIRE(shape.has_value(), "an area that has been looked at");
  steps_ = static_cast<int>(std::max(0.0, MarginOf(*shape) - tracking.value()) / kStep);
  if (region_.free_space() == nullptr) return;
  FindSteps();
  zone_steps_ = steps_;
  if (!shape->zones().empty()) FindZoneSteps(area);
}

void FenceAllowance::FindSteps() {
  // Every clearance falls by as much as the allowance grows.
  constexpr double kKept = 0.85;
  const FreeSpace& space = *region_.free_space();
  const double room = RoomOf(space, turn_radius_.value());
  while (steps_ > 0 && RoomOf(space, turn_radius_.value() + kStep * steps_) < kKept * room) {
    --steps_;
  }
}

void FenceAllowance::FindZoneSteps(const SurveyArea& area) {
  constexpr double kKept = 0.95;
  constexpr int kMost = 12;  // 3 m
  while (zone_steps_ < kMost) {
    const Region nearer(area, {.border = tracking_, .zones = At(zone_steps_ + 1)}, {});
    const Meters reach(kStep * (zone_steps_ + 1));
    if (RoomInReach(*region_.free_space(), *nearer.free_space(), turn_radius_, reach) < kKept) {
      return;
    }
    ++zone_steps_;
  }
}

FenceAllowance::Slack FenceAllowance::SlackFrom(const Pose2& here) const {
  const double radius = turn_radius_.value();
  Slack most{.border = -std::numeric_limits<double>::infinity(), .zones = 0.0};
  for (const double side : {-1.0, 1.0}) {
    const PlanePoint centre(here.north - side * radius * std::sin(here.yaw),
                            here.east + side * radius * std::cos(here.yaw));
    const double slack = region_.Clearance(centre) - radius;
    if (slack > most.border) {
      most = {.border = slack, .zones = region_.ZoneClearance(centre) - radius};
    }
  }
  return most;
}

Meters FenceAllowance::Kept(Meters place_sigma, Meters held, double possible) const {
  const double wanted = std::ceil(kSigmas * place_sigma.value() / kStep - 1e-6);
  // Written so that what is no number is 0.
  const double steps = wanted > 0.0 ? std::min(wanted, possible) : 0.0;
  const double held_steps = std::round((held - tracking_).value() / kStep);
  const bool stays = steps < held_steps && held_steps <= possible && held_steps < steps + 2.0;
  return At(stays ? held_steps : steps);
}

KeptOff FenceAllowance::For(const Pose2& here, Meters place_sigma, const KeptOff& held,
                            Meters sight) const {
  const auto steps_in = [](double slack) { return std::max(0.0, std::floor(slack / kStep)); };
  const Slack slack = SlackFrom(here);
  const double off_border = std::min(static_cast<double>(steps_), steps_in(slack.border));
  const Meters border = Kept(place_sigma, held.border, off_border);
  if (region_.free_space() == nullptr) return {.border = border, .zones = border};
  const double in_sight =
      std::max(steps_in((sight - tracking_).value()), static_cast<double>(steps_));
  const double off_zones =
      std::min({static_cast<double>(zone_steps_), in_sight, steps_in(slack.zones)});
  return {.border = border, .zones = Kept(place_sigma, held.zones, off_zones)};
}

}  // namespace limpet
