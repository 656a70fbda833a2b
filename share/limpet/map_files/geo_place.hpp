// SPDX-License-Identifier: MIT
// A place of the local frame as files have it that know where on earth it is.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "limpet/core/geodesy.hpp"

namespace limpet {

/// "latitude,longitude" of a place [deg]; without a datum two empty fields.
[[nodiscard]] std::string GeoFields(const std::optional<GeoPoint>& datum,
                                    const Eigen::Vector3d& p_W);

/// A position of GeoJSON: longitude and latitude [deg], to a millimetre.
[[nodiscard]] nlohmann::ordered_json GeoPosition(const LocalGrid& grid, const Eigen::Vector2d& p_W);

}  // namespace limpet
