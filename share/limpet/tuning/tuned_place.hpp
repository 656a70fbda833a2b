// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/config.hpp"
#include "limpet/preflight/mission_reading.hpp"

namespace limpet {

/// Where a mission says a parameter of a behavior or an app, and what.
struct TunedPlace {
  std::string owner, key;
  std::string value{};     ///< in force: the block's, a global's, or the default; as text
  SourceLine block{};      ///< its first line; line 0: the mission has no such block
  SourceLine entry{};      ///< line that says it inside the block; line 0: none does
  SourceLine name_line{};  ///< of a behavior: its `name`; line 0 if it has none
  std::string updates{};   ///< of a behavior: the variable that updates it; empty: none
  bool is_behavior = false;
};

/// The place of `owner.key`. Throws ConfigError with the nearest name if the mission has no such
/// owner, or the owner no such parameter.
[[nodiscard]] TunedPlace FindTunedPlace(const MissionReading& mission, const std::string& name);

}  // namespace limpet
