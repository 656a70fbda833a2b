// SPDX-License-Identifier: MIT
// What the tests of pSurvey start it with.
#pragma once

#include "apps/pSurvey/survey_app.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {

inline AppContext ContextOn(TestLink& link) {
  AppContext context;
  context.name = "pSurvey";
  context.link = &link;
  return context;
}

/// table1's rectangle.
inline SurveyApp::Params OfTable() {
  SurveyApp::Params params;
  params.north_min = Meters(-15.0);
  params.north_max = Meters(15.0);
  params.east_min = Meters(-18.0);
  params.east_max = Meters(18.0);
  return params;
}

}  // namespace limpet
