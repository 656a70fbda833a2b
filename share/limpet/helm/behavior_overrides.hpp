// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/mission/behavior_file.hpp"

namespace limpet {

/// `name.key=value` becomes an entry of the behavior called name. Throws ConfigError if no behavior
/// has that name.
void ApplyBehaviorSettings(std::vector<BehaviorFile>& files,
                           const std::vector<std::string>& settings);

}  // namespace limpet
