// SPDX-License-Identifier: MIT
// When a survey is over, and whether that is by its own judgement.
#include <algorithm>

#include <fmt/format.h>

#include "apps/pSurvey/survey_app.hpp"
#include "apps/pSurvey/survey_warnings.hpp"

namespace limpet {
namespace {

/// A survey that the helm has given up for so long, short of its target by slivers, is over.
constexpr Seconds kGivenUpFor(10.0);
constexpr double kNearTarget = 0.98;
/// Farther from it the helm may yet find a way that shows more; not after so long without any.
constexpr Seconds kInVainFor(40.0);
constexpr double kFarFromTarget = 0.95;

}  // namespace

bool SurveyApp::IsGivenUp(Seconds now) const {
  if (!given_up_since_ || OpenRevisits() > 0) return false;
  const double covered = CoveredShare(coverage_);
  const double target = AttainableShare() * params_.coverage_target;
  const Seconds in_vain = now - std::max(*given_up_since_, last_progress_);
  return (covered >= kNearTarget * target && now - *given_up_since_ > kGivenUpFor) ||
         (covered >= kFarFromTarget * target && in_vain > kInVainFor);
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
