// SPDX-License-Identifier: MIT
#include "limpet/waypoints/polygon_entry.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "limpet/core/frames.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

/// The turn at a corner on the way from `from` to the corner after it, starboard positive [rad].
double TurnAt(const ConvexPolygon& polygon, bool is_clockwise, std::size_t corner,
              const MapPoint& from) {
  const std::size_t count = polygon.corners().size();
  const MapPoint& here = polygon.corners()[corner];
  const MapPoint& after = polygon.corners()[(corner + (is_clockwise ? 1 : count - 1)) % count];
  return WrapAngle(BearingTo(here, after) - BearingTo(from, here));
}

std::size_t FromOutside(const ConvexPolygon& polygon, bool is_clockwise, const MapPoint& from) {
  std::size_t best = 0;
  double best_turn = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
    if (!polygon.Shows(i, from)) continue;
    // Clockwise rounds turn to starboard; a turn to port would be one against the rounds.
    const double turn = TurnAt(polygon, is_clockwise, i, from) * (is_clockwise ? 1.0 : -1.0);
    if (turn > best_turn) {
      best_turn = turn;
      best = i;
    }
  }
  return best;
}

std::size_t FromInside(const ConvexPolygon& polygon, bool is_clockwise, const MapPose& vehicle,
                       double inertia) {
  const auto off_ahead = [&](std::size_t i) {
    return std::abs(WrapAngle(BearingTo(vehicle.at, polygon.corners()[i]) - vehicle.heading));
  };
  std::size_t ahead = 0;
  for (std::size_t i = 1; i < polygon.corners().size(); ++i) {
    if (off_ahead(i) < off_ahead(ahead)) ahead = i;
  }
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
    const double turn =
        std::abs(TurnAt(polygon, is_clockwise, i, vehicle.at)) - (i == ahead ? inertia : 0.0);
    if (turn < least) {
      least = turn;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::size_t EntryCorner(const ConvexPolygon& polygon, bool is_clockwise, const MapPose& vehicle,
                        double inertia) {
  return polygon.Contains(vehicle.at) ? FromInside(polygon, is_clockwise, vehicle, inertia)
                                      : FromOutside(polygon, is_clockwise, vehicle.at);
}

bool IsClockwiseBest(const ConvexPolygon& polygon, const MapPose& vehicle) {
  const auto turn = [&](bool is_clockwise) {
    const std::size_t corner = FromOutside(polygon, is_clockwise, vehicle.at);
    return std::abs(WrapAngle(BearingTo(vehicle.at, polygon.corners()[corner]) - vehicle.heading));
  };
  return turn(true) < turn(false);
}

}  // namespace limpet
