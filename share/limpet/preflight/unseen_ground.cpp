// SPDX-License-Identifier: MIT
#include "limpet/preflight/unseen_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "limpet/planning/room.hpp"
#include "limpet/preflight/joined_rooms.hpp"

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

std::vector<PlanePoint> PlacesOf(const FreeSpace::Raster& raster,
                                 const std::vector<std::uint8_t>& cells) {
  std::vector<PlanePoint> places;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells[cell] != 0) places.push_back(raster.Center(cell));
  }
  return places;
}

/// Distance to the nearest of the places [m].
double DistanceTo(const std::vector<PlanePoint>& places, const PlanePoint& at) {
  double least2 = std::numeric_limits<double>::infinity();
  for (const PlanePoint& place : places)
    least2 = std::min(least2, (place - at).squaredNorm());
  return std::sqrt(least2);
}

/// Whether some cell is in both.
bool AreMet(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  for (std::size_t cell = 0; cell < a.size(); ++cell) {
    if (a[cell] != 0 && b[cell] != 0) return true;
  }
  return false;
}

/// Distance to the room [m]; 0 in it.
double DistanceTo(const FreeSpace::Raster& raster, const std::vector<std::uint8_t>& room,
                  const std::vector<PlanePoint>& rim, const PlanePoint& at) {
  const auto cell = raster.At(at);
  if (cell && room[*cell] != 0) return 0.0;
  return DistanceTo(rim, at);
}

}  // namespace

std::optional<UnseenShare> UnseenGround(const SurveyFacts& survey, const Region& region,
                                        const std::optional<PlanePoint>& start) {
  const FreeSpace& space = *region.free_space();
  const std::vector<std::uint8_t> largest = RoomToTurn(space, survey.turning_radius);
  // Who comes from outside is led to the largest room.
  const std::vector<std::uint8_t> first = start && region.Contains(*start)
                                              ? RoomToTurnFrom(space, *start, survey.turning_radius)
                                              : largest;
  const auto& [room, passage] = JoinRooms(space, first, survey.turning_radius);
  const std::vector<PlanePoint> rim = RimOf(space.raster(), room);
  const std::vector<PlanePoint> passages = PlacesOf(space.raster(), passage);
  const auto shape = SurveyShape::Of(survey.area);
  if (rim.empty() || !shape) return std::nullopt;
  // The vehicle gets a turn's radius away from the centres of turns, and sees half an image more;
  // through a passage it goes straight on.
  const double half = std::max(survey.footprint().half_across(Footprint::kLayers - 1), 0.0);
  const double slack = space.raster().slack();
  const double reach = survey.turning_radius + slack + half;
  const double reach_beside = std::max(half - slack, 0.0);
  const PlanePoint low = shape->outline().low(), high = shape->outline().high();
  const double step =
      std::max(kFinestStep, std::sqrt((high - low).x() * (high - low).y() / kMostPlaces));
  double wanted = 0.0, unseen = 0.0, farthest = 0.0;
  UnseenShare found{.is_start_shut_off = !AreMet(room, largest)};
  for (double north = low.x() + 0.5 * step; north < high.x(); north += step) {
    for (double east = low.y() + 0.5 * step; east < high.y(); east += step) {
      if (!shape->Wants({north, east})) continue;
      wanted += 1.0;
      const double distance = DistanceTo(space.raster(), room, rim, {north, east});
      if (distance <= reach || DistanceTo(passages, {north, east}) <= reach_beside) continue;
      unseen += 1.0;
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
