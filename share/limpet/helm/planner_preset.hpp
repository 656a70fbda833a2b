// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/view_params.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {

/// A behavior that runs in the place of another, so that one .bhv file serves every planner.
struct StandIn {
  std::string stands_for;  ///< type in the .bhv file
  std::string type;
  std::vector<ConfigEntry> settings{};  ///< what the file does not say of it
};

/// What `planner` of the helm's block is short for.
struct PlannerPreset {
  std::string generators;
  std::vector<StandIn> stand_ins;
  OptionOrder order = OptionOrder::kPerMetre;
  bool decides_at_views_only = false;  ///< paths are flown to their end, whatever happens
};

/// The preset of `params.planner`, with its own generators if `params` names none.
[[nodiscard]] PlannerPreset PresetOf(const ViewParams& params);

/// Lets the stand-ins take their places. Each keeps name, conditions and flags, and those
/// parameters that it has too; its weight is 1, because its bids have another unit.
void ApplyStandIns(const PlannerPreset& preset, std::vector<BehaviorFile>& files);

}  // namespace limpet
