// SPDX-License-Identifier: MIT
#include "limpet/helm/planner_preset.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

/// Every option is completed to the end of the survey by the plan of the whole.
PlannerPreset LimpetPreset() {
  return {.generators = "beam, gaps, view_tree, tour, plan, home, transit",
          .stand_ins = {},
          .order = OptionOrder::kPerMetre,
          .decides_at_views_only = false};
}

/// Conventional lanes, with looks at objects on the way: the baseline.
PlannerPreset LawnmowerPreset() {
  PlannerPreset preset = LimpetPreset();
  preset.generators = "lanes, gaps, tour, home, transit";
  return preset;
}

/// P0 of docs/references.md: the branch with the greatest sum of nats, flown view by view.
PlannerPreset PaperPreset(double lambda) {
  const ConfigEntry lambda_entry{
      .key = "lambda", .value = fmt::format("{}", lambda), .where = {.file = "pHelm", .line = 0}};
  return {.generators = "paper, home, transit",
          .stand_ins = {{.stands_for = "BHV_CoverArea", .type = "BHV_ReduceMapEntropy"},
                        {.stands_for = "BHV_RevisitOpi",
                         .type = "BHV_ReduceObjectEntropy",
                         .settings = {lambda_entry}}},
          .order = OptionOrder::kBySum,
          .decides_at_views_only = true};
}

PlannerPreset PresetCalled(const ViewParams& params) {
  if (params.planner == "paper") return PaperPreset(params.paper_lambda);
  if (params.planner == "lawnmower") return LawnmowerPreset();
  return LimpetPreset();
}

bool IsWeight(const std::string& key) {
  return EqualsIgnoringCase(key, "pwt") || EqualsIgnoringCase(key, "priority");
}

/// Whether a behavior of the stand-in's type may be given `key`, its weight apart.
bool Takes(const std::vector<ParamSpec>& specs, const std::string& key) {
  const auto is_key = [&key](const std::string& name) { return EqualsIgnoringCase(name, key); };
  return !IsWeight(key) && (std::ranges::any_of(CommonBehaviorKeys(), is_key) ||
                            std::ranges::any_of(specs, is_key, &ParamSpec::name));
}

void Replace(ConfigBlock& block, const StandIn& stand_in) {
  const auto entry = BehaviorRegistry().find(stand_in.type);
  const std::vector<ParamSpec> specs = entry == BehaviorRegistry().end()
                                           ? std::vector<ParamSpec>()  // the host will complain
                                           : entry->second.describe();
  const std::string name = BehaviorNameOf(block);
  block.name = stand_in.type;
  std::erase_if(block.entries, [&specs](const ConfigEntry& e) { return !Takes(specs, e.key); });
  block.entries.push_back({.key = "pwt", .value = "1", .where = block.where});
  if (block.Find("name") == nullptr) {
    block.entries.push_back({.key = "name", .value = name, .where = block.where});
  }
  block.entries.insert(block.entries.end(), stand_in.settings.begin(), stand_in.settings.end());
}

}  // namespace

PlannerPreset PresetOf(const ViewParams& params) {
  PlannerPreset preset = PresetCalled(params);
  if (!params.generators.empty()) {
    preset.generators = params.generators;
  }
  return preset;
}

void ApplyStandIns(const PlannerPreset& preset, std::vector<BehaviorFile>& files) {
  for (BehaviorFile& file : files) {
    for (ConfigBlock& block : file.behaviors) {
      const auto stand_in = std::ranges::find(preset.stand_ins, block.name, &StandIn::stands_for);
      if (stand_in != preset.stand_ins.end()) {
        Replace(block, *stand_in);
      }
    }
  }
}

}  // namespace limpet
