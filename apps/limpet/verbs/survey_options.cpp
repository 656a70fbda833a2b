// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/survey_options.hpp"

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
           .meaning = "limpet, or paper: the 2025 paper's planner (default: the mission's)"},
          {.names = "--gain",
           .value = "G",
           .meaning = "full, or coverage: objects have no say (default: the mission's)"},
          {.names = "--without-truth",
           .meaning = "withhold SIM_* from every app on board (the result must not change)"}};
}

}  // namespace limpet
