// SPDX-License-Identifier: MIT
// Areas as a GIS writes them: GeoJSON and KML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/geodesy.hpp"
#include "limpet/survey/simple_polygon.hpp"

namespace limpet {

/// What is farther from the datum, or from the vehicle, is another site [m].
inline constexpr double kFarthestSite = 20e3;

/// The rings of one polygon [deg], none of them closed by its first corner again.
struct GeoPolygon {
  std::vector<GeoPoint> outline;
  std::vector<std::vector<GeoPoint>> holes;
};

/// The one polygon of a text: a GeoJSON geometry, feature or collection of features, or a KML
/// document, told apart by their first letter. The error says what is wrong: also if there are
/// several polygons, as nobody knows which is meant, something of which nobody knows whether it is
/// one, another frame than WGS84, or a corner that is no place on earth.
[[nodiscard]] Expected<GeoPolygon> ParseGeoArea(std::string_view text);

/// The ring on the local grid of the datum, NED [m]. The error says how far off a corner is:
/// farther than kFarthestSite from the datum it is another site, or latitude and longitude are
/// exchanged.
[[nodiscard]] Expected<std::vector<PlanePoint>> PlacesOnGrid(const std::vector<GeoPoint>& ring,
                                                             const GeoPoint& datum);

}  // namespace limpet
