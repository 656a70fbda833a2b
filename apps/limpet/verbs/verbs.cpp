// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/verbs.hpp"

#include "apps/limpet/verbs/change.hpp"
#include "apps/limpet/verbs/check.hpp"
#include "apps/limpet/verbs/community.hpp"
#include "apps/limpet/verbs/describe.hpp"
#include "apps/limpet/verbs/detect.hpp"
#include "apps/limpet/verbs/key.hpp"
#include "apps/limpet/verbs/launch.hpp"
#include "apps/limpet/verbs/log.hpp"
#include "apps/limpet/verbs/map.hpp"
#include "apps/limpet/verbs/nav.hpp"
#include "apps/limpet/verbs/new.hpp"
#include "apps/limpet/verbs/plug.hpp"
#include "apps/limpet/verbs/report.hpp"
#include "apps/limpet/verbs/safety.hpp"
#include "apps/limpet/verbs/session.hpp"
#include "apps/limpet/verbs/survey.hpp"
#include "apps/limpet/verbs/tables.hpp"
#include "apps/limpet/verbs/tune.hpp"
#include "apps/limpet/verbs/why.hpp"
#include "apps/limpet/verbs/work.hpp"

namespace limpet {

const std::vector<Verb>& Verbs() {
  static const std::vector<Verb> verbs{
      {"survey", "survey twice, embedded, and report what changed", RunSurvey},
      {"change", "compare two saved sessions again", RunChange},
      {"nav", "run the estimator alone on a recorded sensor stream", RunNav},
      {"detect", "run the detector alone on images", RunDetect},
      {"check", "report every problem of a mission", RunCheck},
      {"safety", "the safety rules, with a mission's limits", RunSafety},
      {"describe", "every parameter and every variable, from the code", RunDescribe},
      {"report", "figures and page again from a run's logs", RunReport},
      {"tables", "many seeds: the paper's tables beside ours", RunTables},
      {"tune", "which setting of a mission is best, over many seeds", RunTune},
      {"work", "run the tasks of a sweep, as jobs of a cluster do", RunWork},
      {"key", "make a key for sealed routes of pShare", RunKey},
      {"launch", "run a mission as separate processes and watch over them", RunLaunchVerb},
      {"status", "who is up in a community, and who is missing", RunStatusVerb},
      {"scope", "look at the variables of a community, live", RunScopeVerb},
      {"poke", "write variables of a community and read them back", RunPokeVerb},
      {"play", "play a log into a community", RunPlayVerb},
      {"log", "look into a log: scan, stat, grep, clip, csv, recover, rawlog", RunLog},
      {"why", "why the helm did what it did, from a log or live", RunWhy},
      {"session", "a saved session that was cut short: recover", RunSession},
      {"map", "a saved session's map: info, export, diff", RunMap},
      {"new", "a repository of your own with a behavior or an app", RunNew},
      {"plug", "expand a mission template, as nsplug does", RunPlug},
  };
  return verbs;
}

}  // namespace limpet
