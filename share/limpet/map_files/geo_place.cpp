// SPDX-License-Identifier: MIT
#include "limpet/map_files/geo_place.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

/// 1e-8 degrees are a millimetre.
double ToMillimetre(double degrees) { return std::round(degrees * 1e8) / 1e8; }

}  // namespace

std::string GeoFields(const std::optional<GeoPoint>& datum, const Eigen::Vector3d& p_W) {
  if (!datum) return ",";
  const GeoPoint place = LocalGrid(*datum).At(p_W.head<2>());
  return fmt::format("{:.8f},{:.8f}", place.latitude_deg, place.longitude_deg);
}

nlohmann::ordered_json GeoPosition(const LocalGrid& grid, const Eigen::Vector2d& p_W) {
  const GeoPoint place = grid.At(p_W);
  return {ToMillimetre(place.longitude_deg), ToMillimetre(place.latitude_deg)};
}

}  // namespace limpet
