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
  // Every clearance falls by as much as the allowance grows.
  constexpr double kKept = 0.85;
  const FreeSpace& space = *region_.free_space();
  const double room = RoomOf(space, turn_radius.value());
  while (steps_ > 0 && RoomOf(space, turn_radius.value() + kStep * steps_) < kKept * room) {
    --steps_;
  }
}

int FenceAllowance::StepsFrom(const Pose2& here) const {
  double slack = -std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const PlanePoint centre(here.north - side * turn_radius_.value() * std::sin(here.yaw),
                            here.east + side * turn_radius_.value() * std::cos(here.yaw));
    slack = std::max(slack, region_.Clearance(centre) - turn_radius_.value());
  }
  return slack > 0.0 ? std::min(steps_, static_cast<int>(slack / kStep)) : 0;
}

Meters FenceAllowance::For(const Pose2& here, Meters place_sigma, Meters held) const {
  const int possible = StepsFrom(here);
  const double wanted = std::ceil(kSigmas * place_sigma.value() / kStep - 1e-6);
  // Written so that what is no number is 0.
  const double steps = wanted > 0.0 ? std::min(wanted, static_cast<double>(possible)) : 0.0;
  const double held_steps = std::round((held - tracking_).value() / kStep);
  const bool stays = steps < held_steps && held_steps <= possible && held_steps < steps + 2.0;
  return tracking_ + Meters(kStep * (stays ? held_steps : steps));
}

}  // namespace limpet
