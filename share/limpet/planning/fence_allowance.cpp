// SPDX-License-Identifier: MIT
#include "limpet/planning/fence_allowance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "limpet/core/require.hpp"
#include "limpet/planning/fence_slack.hpp"
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

double FenceAllowance::Wanted(Meters place_sigma) {
  const double wanted = std::ceil(kSigmas * place_sigma.value() / kStep - 1e-6);
  return wanted > 0.0 ? wanted : 0.0;  // what is no number is 0
}

double FenceAllowance::StepsOf(Meters allowance) const {
  return std::round((allowance - tracking_).value() / kStep);
}

Meters FenceAllowance::Kept(double wanted, Meters held, double possible) const {
  const double steps = std::min(wanted, possible);
  const double held_steps = StepsOf(held);
  const bool stays = steps < held_steps && held_steps <= possible && held_steps < steps + 2.0;
  return At(stays ? held_steps : steps);
}

KeptOff FenceAllowance::For(const Pose2& here, Meters place_sigma, const KeptOff& held,
                            Meters sight) const {
  const auto steps_in = [](double slack) { return std::max(0.0, std::floor(slack / kStep)); };
  const double wanted = Wanted(place_sigma);
  const double in_sight =
      std::max(steps_in((sight - tracking_).value()), static_cast<double>(steps_));
  const double room = steps_, zone_room = std::min(static_cast<double>(zone_steps_), in_sight);
  const double zones_wanted = std::min(zone_room, std::max(wanted, StepsOf(held.zones)));
  const FenceSlack slack = SlackToTurn(region_, here, turn_radius_, kStep * zones_wanted);
  const Meters border = Kept(wanted, held.border, std::min(room, steps_in(slack.border)));
  if (region_.free_space() == nullptr) return {.border = border, .zones = border};
  return {.border = border,
          .zones = Kept(wanted, held.zones, std::min(zone_room, steps_in(slack.zones)))};
}

}  // namespace limpet
