// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/verbs.hpp"

#include "apps/limpet/verbs/check.hpp"
#include "apps/limpet/verbs/survey.hpp"

namespace limpet {

const std::vector<Verb>& Verbs() {
  static const std::vector<Verb> verbs{
      {"survey", "survey twice, embedded, and report what changed", RunSurvey},
      {"check", "report every problem of a mission", RunCheck},
  };
  return verbs;
}

}  // namespace limpet
