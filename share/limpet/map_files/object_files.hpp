// SPDX-License-Identifier: MIT
// A session's objects for tables and geographic information systems.
#pragma once

#include <optional>
#include <string>

#include "limpet/core/geodesy.hpp"
#include "limpet/session/datum.hpp"
#include "limpet/session/saved_session.hpp"

namespace limpet {

/// id,class,decided,p_present,north_m,east_m,down_m,sd_north_m,sd_east_m,sd_down_m,
/// latitude_deg,longitude_deg,looks,radius_m,radius_sd_m: one row each; without a datum the
/// geographic columns are empty.
[[nodiscard]] std::string ObjectsToCsv(const SavedSession& session);

/// GeoJSON (RFC 7946): a point for each object, the survey area as a polygon.
[[nodiscard]] std::string ObjectsToGeoJson(const SavedSession& session, const GeoPoint& datum);

}  // namespace limpet
