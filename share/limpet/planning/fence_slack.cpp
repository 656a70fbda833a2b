// SPDX-License-Identifier: MIT
#include "limpet/planning/fence_slack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace limpet {
namespace {

constexpr std::array kSides = {-1.0, 1.0};

FenceSlack Less(const FenceSlack& a, const FenceSlack& b) {
  return {.border = std::min(a.border, b.border), .zones = std::min(a.zones, b.zones)};
}

/// Ways to a full turn: which leaves zones most.
class WayToTurn {
 public:
  WayToTurn(const Region& region, Meters radius) : region_(region), radius_(radius.value()) {}

  [[nodiscard]] FenceSlack AtOnce(const Pose2& here) const {
    FenceSlack most{.border = -std::numeric_limits<double>::infinity(), .zones = 0.0};
    for (const double side : kSides) {
      const FenceSlack slack = OfTurn(here, side);
      if (slack.border > most.border) most = slack;
    }
    return most;
  }

  /// `most`, or what a turn after an arc and a straight line leaves zones, at no less for borders
  /// and none of which `region` itself is too narrow for; no more than `enough` is looked for.
  [[nodiscard]] FenceSlack Later(const Pose2& here, FenceSlack most, double enough) {
    constexpr double kArc = std::numbers::pi / 12.0;
    least_border_ = std::max(0.0, most.border);
    for (const double side : kSides) {
      Pose2 pose = here;
      FenceSlack way = At(here);
      for (double turned = 0.0; turned < std::numbers::pi; turned += kArc) {
        if (!IsBetter(way, most) || most.zones >= enough) break;
        TakeStraightOn(pose, way, most);
        pose = Advance(pose, {.curvature = side / radius_, .length = kArc * radius_});
        way = Less(way, At(pose));
      }
    }
    return most;
  }

 private:
  [[nodiscard]] bool IsBetter(const FenceSlack& slack, const FenceSlack& than) const {
    return slack.border >= least_border_ && slack.zones > than.zones;
  }
  [[nodiscard]] FenceSlack At(const Pose2& pose) const {
    const PlanePoint at(pose.north, pose.east);
    return {.border = region_.Clearance(at), .zones = region_.ZoneClearance(at)};
  }
  [[nodiscard]] FenceSlack OfTurn(const Pose2& pose, double side) const {
    const PlanePoint centre(pose.north - side * radius_ * std::sin(pose.yaw),
                            pose.east + side * radius_ * std::cos(pose.yaw));
    return {.border = region_.Clearance(centre) - radius_,
            .zones = region_.ZoneClearance(centre) - radius_};
  }
  /// Looks for a turn on the way straight ahead from `pose`, up to which `way` is left.
  void TakeStraightOn(const Pose2& pose, FenceSlack way, FenceSlack& most) const {
    constexpr double kStep = 0.5, kFarthest = 25.0;  // [m]
    for (double ahead = 0.0; ahead <= kFarthest; ahead += kStep) {
      const Pose2 there = Advance(pose, {.curvature = 0.0, .length = ahead});
      way = Less(way, At(there));
      if (!IsBetter(way, most)) return;  // no turn farther on leaves more
      for (const double side : kSides) {
        const FenceSlack slack = Less(way, OfTurn(there, side));
        if (IsBetter(slack, most)) most.zones = slack.zones;
      }
    }
  }

  const Region& region_;
  double radius_;
  double least_border_ = 0.0;  ///< [m]
};

}  // namespace

FenceSlack SlackToTurn(const Region& region, const Pose2& here, Meters radius,
                       double enough_zones) {
  WayToTurn way(region, radius);
  const FenceSlack at_once = way.AtOnce(here);
  return at_once.zones < enough_zones ? way.Later(here, at_once, enough_zones) : at_once;
}

}  // namespace limpet
