// SPDX-License-Identifier: MIT
// What changed between two sessions, for tables and geographic information systems.
#pragma once

#include <string>

#include "limpet/comparison/session_comparison.hpp"
#include "limpet/core/geodesy.hpp"

namespace limpet {

/// decided,class,p_confirmed,p_removed,p_new,north_m,east_m,down_m,latitude_deg,longitude_deg,id_a,
/// landmark_b,looks_b: one row per object of either session, in the later one's frame; without a
/// datum the geographic columns are empty.
[[nodiscard]] std::string ChangesToCsv(const SessionComparison& comparison);

/// GeoJSON (RFC 7946): a point for each object.
[[nodiscard]] std::string ChangesToGeoJson(const SessionComparison& comparison,
                                           const GeoPoint& datum);

}  // namespace limpet
