// SPDX-License-Identifier: MIT
#include "limpet/planning/pass.hpp"

#include <numbers>

namespace limpet {
namespace {

constexpr double kOutsidePrice = 200.0;  // [m]

}  // namespace

Pass Pass::Reversed() const {
  const Pose2 end = out();
  return {.in = {end.north, end.east, end.yaw + std::numbers::pi}, .length = length};
}

bool Pass::operator==(const Pass& other) const {
  return in.north == other.in.north && in.east == other.in.east && in.yaw == other.in.yaw &&
         length == other.length;
}

bool IsInside(const Pass& pass, const Region& region) {
  return region.Contains(pass.in, PathSegment{.curvature = 0.0, .length = pass.length});
}

double PassLink::Price() const { return word.length + (is_inside ? 0.0 : kOutsidePrice); }

PassLink LinkBetween(const Pose2& from, const Pose2& to, const Region& region, Meters turn_radius) {
  if (const auto inside = region.ShortestWordInside(from, to, turn_radius)) return {*inside};
  return {.word = DubinsWords(from, to, turn_radius).shortest(), .is_inside = false};
}

}  // namespace limpet
