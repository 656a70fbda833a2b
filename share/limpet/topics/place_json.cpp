// SPDX-License-Identifier: MIT
#include "limpet/topics/place_json.hpp"

#include <nlohmann/json.hpp>

namespace limpet {

nlohmann::ordered_json PlaceJson(const std::optional<Eigen::Vector3d>& p_W) {
  using OrderedJson = nlohmann::ordered_json;
  return p_W ? OrderedJson{p_W->x(), p_W->y(), p_W->z()} : OrderedJson(nullptr);
}

}  // namespace limpet
