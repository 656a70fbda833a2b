// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// A behavior's settings in force, in one line, as BHV_SETTINGS has them:
/// `type=BHV_Waypoint,name=survey,speed=2,...`; values with commas in quotes. Of each key what the
/// block says, else its default; without keys that may have several lines, and those without value
/// or effect.
[[nodiscard]] std::string SettingsText(const ConfigBlock& block, const std::string& name,
                                       const std::vector<ParamSpec>& specs);

}  // namespace limpet
