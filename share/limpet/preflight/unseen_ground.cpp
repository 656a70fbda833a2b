// SPDX-License-Identifier: MIT
#include "limpet/preflight/unseen_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "limpet/planning/room.hpp"

namespace limpet {
namespace {

constexpr double kMostPlaces = 2e4;
constexpr double kFinestStep = 0.25;  // [m]

/// Cells of the room that have a neighbour outside it, and all of a raster that has no other.
std::vector<PlanePoint> RimOf(const FreeSpace::Raster& raster,
                              const std::vector<std::uint8_t>& room) {
  const auto columns = static_cast<std::size_t>(raster.columns);
  std::vector<PlanePoint> rim;
  for (std::size_t cell = 0; cell < room.size(); ++cell) {
    if (room[cell] == 0) continue;
    const std::size_t row = cell / columns, column = cell % columns;
    const bool is_edge =
        row == 0 || column == 0 || cell + columns >= room.size() || column + 1 == columns;
    if (is_edge || room[cell - 1] == 0 || room[cell + 1] == 0 || room[cell - columns] == 0 ||
        room[cell + columns] == 0) {
      rim.push_back(raster.Center(cell));
    }
  }
  return rim;
}

/// Distance to the room [m]; 0 in it.
double DistanceTo(const FreeSpace::Raster& raster, const std::vector<std::uint8_t>& room,
                  const std::vector<PlanePoint>& rim, const PlanePoint& at) {
  const auto cell = raster.At(at);
  if (cell && room[*cell] != 0) return 0.0;
  double least2 = std::numeric_limits<double>::infinity();
  for (const PlanePoint& place : rim)
    least2 = std::min(least2, (place - at).squaredNorm());
  return std::sqrt(least2);
}

}  // namespace

std::optional<UnseenShare> UnseenGround(const SurveyFacts& survey, const Region& region,
                                        const std::optional<PlanePoint>& start) {
  const FreeSpace& space = *region.free_space();
  const std::vector<std::uint8_t> largest = RoomToTurn(space, survey.turning_radius);
  // Who comes from outside is led to the largest room.
  const std::vector<std::uint8_t> room = start && region.Contains(start->x(), start->y())
                                             ? RoomToTurnFrom(space, *start, survey.turning_radius)
                                             : largest;
  const std::vector<PlanePoint> rim = RimOf(space.raster(), room);
  const auto shape = SurveyShape::Of(survey.area);
  if (rim.empty() || !shape) return std::nullopt;
  // The vehicle gets a turn's radius away from the centres of turns, and sees half an image more.
  const Footprint footprint = survey.footprint();
  const double reach = survey.turning_radius + space.raster().slack() +
                       std::max(footprint.half_across(Footprint::kLayers - 1), 0.0);
  const PlanePoint low = shape->outline().low(), high = shape->outline().high();
  const double step =
      std::max(kFinestStep, std::sqrt((high - low).x() * (high - low).y() / kMostPlaces));
  double wanted = 0.0, unseen = 0.0, farthest = 0.0;
  UnseenShare found{.is_start_shut_off = room != largest};
  for (double north = low.x() + 0.5 * step; north < high.x(); north += step) {
    for (double east = low.y() + 0.5 * step; east < high.y(); east += step) {
      if (!shape->Wants({north, east})) continue;
      wanted += 1.0;
      const double distance = DistanceTo(space.raster(), room, rim, {north, east});
      unseen += distance > reach ? 1.0 : 0.0;
      if (distance > farthest) {
        farthest = distance;
        found.farthest_W = {north, east};
      }
    }
  }
  found.share = unseen / std::max(1.0, wanted);
  return found;
}

}  // namespace limpet
