// SPDX-License-Identifier: MIT
#include "limpet/map_files/geo_json.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "limpet/map_files/geo_place.hpp"

namespace limpet {

nlohmann::ordered_json GeoPointJson(const LocalGrid& grid, const Eigen::Vector3d& p_W) {
  return {{"type", "Point"}, {"coordinates", GeoPosition(grid, p_W.head<2>())}};
}

std::string FeatureCollectionText(nlohmann::ordered_json features) {
  const nlohmann::ordered_json collection{{"type", "FeatureCollection"},
                                          {"features", std::move(features)}};
  return collection.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace limpet
