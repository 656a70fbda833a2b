// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/view_params.hpp"

namespace limpet {

/// The helm's own block; behaviors have their .bhv file.
struct HelmParams {
  std::vector<std::string> behaviors{"mission.bhv"};
  std::vector<std::string> behavior_setting;
  std::vector<std::string> behavior_path;
  std::vector<std::string> domain{"course:0:359:360", "speed:0:1:21", "depth:0:100:1001"};
  ViewParams views;

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit.Required("behaviors", behaviors, "Behavior files, relative to the mission folder");
    visit("behavior_setting", behavior_setting, "Overrides of behavior files: name.key=value");
    visit(
        "behavior_path", behavior_path,
        "Folders with behaviors of your own, libBHV_Name.so, several separated by `:`; relative to "
        "the mission folder. Those of the environment's LIMPET_BEHAVIOR_PATH come on top");
    visit.Required("domain", domain, "Decision variables, name:low:high:points");
    views.Describe(visit);
  }
};

}  // namespace limpet
