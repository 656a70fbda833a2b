// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/survey_options.hpp"

#include <fmt/format.h>

namespace limpet {

std::vector<CommandOption> SurveyMethodOptions() {
  return {{.names = "--sessions",
           .value = "LIST",
           .meaning = "sessions of scenario.yaml in order; each is compared with the one before "
                      "it, the first with what --out already has",
           .fallback = "discovery,change"},
          {.names = "--set",
           .value = "OWNER.KEY=V",
           .meaning =
               "override a parameter of an app, or of a behavior by its name; KEY=V: a global of "
               "the mission, e.g. VehicleFile=bluerov2.yaml",
           .is_repeatable = true},
          {.names = "--planner",
           .value = "P",
           .meaning = "limpet, lawnmower, or paper: the 2025 paper's planner (default: the "
                      "mission's)"},
          {.names = "--gain",
           .value = "G",
           .meaning = "full, or coverage: objects have no say (default: the mission's)"},
          {.names = "--without-truth",
           .meaning = "withhold SIM_* from every app on board (the result must not change)"}};
}

std::vector<std::string> SurveyOptionsGiven(const Arguments& given) {
  std::vector<std::string> options;
  for (const CommandOption& option : SurveyMethodOptions()) {
    const bool is_flag = option.value.empty();
    if (is_flag && given.Has(option.names.substr(2))) options.push_back(option.names);
    if (is_flag) continue;
    for (const std::string& value : given.All(option.names.substr(2))) {
      options.push_back(fmt::format("{}={}", option.names, value));
    }
  }
  return options;
}

}  // namespace limpet
