// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

namespace limpet {

/// `[north, east, down]`, or null.
[[nodiscard]] nlohmann::ordered_json PlaceJson(const std::optional<Eigen::Vector3d>& p_W);

}  // namespace limpet
