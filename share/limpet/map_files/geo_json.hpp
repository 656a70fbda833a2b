// SPDX-License-Identifier: MIT
// What the GeoJSON files of this library have in common.
#pragma once

#include <string>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "limpet/core/geodesy.hpp"

namespace limpet {

/// The geometry of a feature at a place.
[[nodiscard]] nlohmann::ordered_json GeoPointJson(const LocalGrid& grid,
                                                  const Eigen::Vector3d& p_W);

/// The text of a file of these features. Bytes that are no UTF-8 are replaced: names come from
/// anywhere.
[[nodiscard]] std::string FeatureCollectionText(nlohmann::ordered_json features);

}  // namespace limpet
