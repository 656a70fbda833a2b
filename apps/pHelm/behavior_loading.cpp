// SPDX-License-Identifier: MIT
#include "apps/pHelm/behavior_loading.hpp"

#include "limpet/core/clock.hpp"
#include "limpet/helm/behavior_modules.hpp"
#include "limpet/helm/behavior_overrides.hpp"
#include "limpet/helm/planner_preset.hpp"
#include "limpet/mission/shared_settings.hpp"

namespace limpet {
namespace {

void LoadForeignBehaviors(const AppContext& context, const HelmParams& params) {
  std::vector<ConfigEntry> lines;
  for (const std::string& folders : params.behavior_path) {
    lines.push_back({.key = "behavior_path", .value = folders, .where = {.file = context.name}});
  }
  LoadBehaviorModules(lines, context.mission_folder);
}

}  // namespace

std::vector<BehaviorFile> LoadBehaviorFiles(const AppContext& context, const HelmParams& params) {
  LoadForeignBehaviors(context, params);
  std::vector<BehaviorFile> files;
  for (const std::string& name : params.behaviors) {
    files.push_back(LoadBehaviors(context.mission_folder / name));
    TakeGlobals(context.globals, files.back().behaviors);
  }
  ApplyBehaviorSettings(files, params.behavior_setting);
  ApplyStandIns(PresetOf(params.views), files);
  return files;
}

RealClock ClockOf(const AppContext& context) {
  return context.runs_live ? RealClock(SteadyTime) : RealClock();
}

}  // namespace limpet
