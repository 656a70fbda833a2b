// SPDX-License-Identifier: MIT
// Posts for other vehicles, `#all` and `#group` of a flag, as MOOS-IvP's vehicles send them.
#pragma once

#include <string>
#include <string_view>

#include "limpet/core/config.hpp"
#include "limpet/helm/behavior_status.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/mission/flag.hpp"

namespace limpet {

/// Who sends it.
struct NodeSender {
  std::string_view node;
  const std::string& behavior;
};

/// The envelope of a post that leaves the vehicle; `group` may be empty.
[[nodiscard]] std::string NodeMessage(const NodeSender& sender, const std::string& group,
                                      const HelmPost& post);
/// The group of this vehicle by what its pNodeReporter said last; empty if it has none.
[[nodiscard]] std::string OwnGroup(const VehicleState& state);
/// False for a `#somebody` that is neither `#all` nor `#group`.
[[nodiscard]] bool IsKnownDestination(const Flag& flag);
/// True for a line with a flag for the vehicle's group.
[[nodiscard]] bool HasGroupFlag(const ConfigEntry& line);

}  // namespace limpet
