// SPDX-License-Identifier: MIT
// `obstacles:` of scenario.yaml, for this library only.
#pragma once

#include <vector>

#include "limpet/mission/scenario.hpp"
#include "limpet/mission/yaml_reader.hpp"

namespace limpet::internal {

/// A list of maps; every problem goes to `in`.
void ReadObstacles(YamlReader& in, const YAML::Node& node,
                   std::vector<ScenarioObstacle>& obstacles);
/// The vehicle must not start in one, and no object may be in one.
void CheckObstacles(YamlReader& in, const YAML::Node& node, const Scenario& scenario);

}  // namespace limpet::internal
