// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/mission/scenario.hpp"

namespace limpet {

/// What is said of a scenario that is not taken; empty for one that is.
inline std::string ScenarioErrorsOf(const std::string& text) {
  try {
    static_cast<void>(ParseScenario(text, "s.yaml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace limpet
