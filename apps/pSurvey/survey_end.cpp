// SPDX-License-Identifier: MIT
// When a survey is over, and whether that is by its own judgement.
#include <fmt/format.h>

#include "apps/pSurvey/survey_app.hpp"
#include "apps/pSurvey/survey_warnings.hpp"

namespace limpet {
namespace {

/// A survey that the helm has given up for so long, short of its target by slivers, is over.
constexpr Seconds kGivenUpFor(10.0);
constexpr double kNearTarget = 0.98;

}  // namespace

bool SurveyApp::IsGivenUp(Seconds now) const {
  return given_up_since_ && now - *given_up_since_ > kGivenUpFor && OpenRevisits() == 0 &&
         CoveredShare(coverage_) >= kNearTarget * AttainableShare() * params_.coverage_target;
}

void SurveyApp::Survey(Seconds now) {
  TrackTransit(now);
  const double attainable = AttainableShare();
  if (attainable > 0.0 && CoveredShare(coverage_) >= attainable * params_.coverage_target &&
      OpenRevisits() == 0) {
    GoHome(attainable < 1.0 ? "what this water shows has been seen" : "coverage target reached",
           "home", now);
  } else if (IsGivenUp(now)) {
    GoHome("what is left is not worth its way", "home", now);
  } else if (now - *deployed_ > params_.max_time) {
    GoHome("out of time", "timeout", now);
  } else if (now - last_progress_ > params_.stall && !transit_.is_over()) {
    Warn(warnings::kTransitStalled, "the area has not come nearer for stall_s; going home");
    GoHome("the area is not reached", "timeout", now);
  } else if (now - last_progress_ > params_.stall && attainable < 1.0) {
    Warn(warnings::kOutOfSight,
         fmt::format("{} shows no more of it from {:g} m; going home",
                     params_.coverage_kind == "seabed" ? "the seabed is out of sight: this water"
                                                       : "this water",
                     params_.altitude.value()));
    GoHome("no more is in sight", "home", now);
  } else if (now - last_progress_ > params_.stall) {
    Warn(warnings::kCoverageStalled,
         "coverage has not grown for stall_s; going home short of the target");
    GoHome("coverage stalled", "timeout", now);
  }
}

}  // namespace limpet
