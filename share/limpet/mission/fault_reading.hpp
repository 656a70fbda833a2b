// SPDX-License-Identifier: MIT
// `faults:` of scenario.yaml, for this library only.
#pragma once

#include <vector>

#include "limpet/mission/fault_kinds.hpp"
#include "limpet/mission/yaml_reader.hpp"

namespace limpet::internal {

/// A list of maps; every problem goes to `in`.
void ReadFaults(YamlReader& in, const YAML::Node& node, std::vector<ScenarioFault>& faults);

}  // namespace limpet::internal
